#include "emulator/scenario/wiring.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "emulator/scenario/figures.hpp"
#include "emulator/scenario/values.hpp"
#include "generator/diagnostic/code_scenario.hpp"

namespace finemote::scenario {
namespace {

namespace code = gen::code;
using gen::json::Value;

bool has_hold(const Place& place, const std::string& what) {
  return std::any_of(place.holds.begin(), place.holds.end(), [&](const auto& hold) { return hold.what == what; });
}

}  // namespace

gen::Diagnostic& Wiring::at(gen::Code code, const Value& value, std::string message) {
  return diagnostics_.error(code, value.at, std::move(message)).underline(value.length);
}

/// The bus a part is on, then those its muxes are on, up to the port.
std::vector<std::string> Wiring::buses_above(const Place& place) const {
  std::vector<std::string> buses{place.bus};
  for (const Place* at = &place; !at->mux.empty() && buses.size() <= names_.parts().size();) {
    const World::Part* mux = names_.find(at->mux);
    if (mux == nullptr || !mux->place) break;
    at = &*mux->place;
    buses.push_back(at->bus);
  }
  return buses;
}

void Wiring::wired_in_order(const Value& entry, const std::set<std::string>& later) {
  for (const char* key : {"mux", "pwm"}) {
    const Value* name = word_in(entry, key);
    if (name == nullptr || names_.find(name->text) != nullptr || later.count(name->text) == 0) continue;
    at(code::bad_scenario, *name,
       fmt::format("'{}' must be listed before the parts that are connected to it", name->text))
        .note("parts are wired in the order of the list");
  }
}

void Wiring::judge(const Value& entry, const Place& place, const std::set<std::string>& later) {
  if (!world_.judges_wiring) return;
  wired_in_order(entry, later);
  for (const World::Part& other : names_.parts()) {
    if (!other.place || contains(world_.shared, place.port)) continue;
    for (const Place::Hold& hold : place.holds) {
      if (has_hold(*other.place, hold.what))
        at(code::bad_scenario, *entry.find(hold.member), fmt::format("'{}' already {}", other.name, hold.what));
    }
  }
  same_address(entry, place);
}

/// A part on a bus is also heard behind every mux there.
void Wiring::same_address(const Value& entry, const Place& place) {
  if (!place.address || place.bus.empty()) return;
  const Value* word = entry.find("address");
  if (word == nullptr) word = entry.find(place.mux.empty() ? "port" : "channel");
  for (const World::Part& other : names_.parts()) {
    if (!other.place || other.place->address != place.address || other.place->bus.empty()) continue;
    if (!contains(buses_above(*other.place), place.bus) && !contains(buses_above(place), other.place->bus)) continue;
    at(code::bad_scenario, *word,
       fmt::format("'{}' already has address {} on {}", other.name, *place.address, other.place->bus));
  }
}

void Wiring::is_heard(const Value& event) {
  const Value *port = word_in(event, "port"), *address = event.find("address");
  if (!world_.judges_wiring || port == nullptr || address == nullptr || !address->is(Value::Kind::number)) return;
  std::string there;
  for (const World::Part& part : names_.parts()) {
    if (!part.place || !part.place->address || buses_above(*part.place).back() != fmt::format("'{}'", port->text))
      continue;
    if (*part.place->address == number_of(*address)) return;
    there += fmt::format("{}{} ('{}')", there.empty() ? "" : ", ", *part.place->address, part.name);
  }
  at(code::scenario_name, *address, fmt::format("no part at '{}' has address {}", port->text, shown(*address)))
      .note(there.empty() ? "no part is there" : "addresses there: " + there);
}

}  // namespace finemote::scenario
