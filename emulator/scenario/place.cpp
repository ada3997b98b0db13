#include "emulator/scenario/place.hpp"

#include <fmt/format.h>

#include <cmath>

#include "emulator/scenario/figures.hpp"

namespace finemote::scenario {
namespace {

using gen::json::Value;

std::string text_in(const Value& entry, const char* key) {
  const Value* value = word_in(entry, key);
  return value == nullptr ? "" : value->text;
}

std::optional<int> number_in(const Value& entry, const Model& model, const char* key) {
  constexpr double kLargest = 1e9;
  const auto number = figure(entry, model, key);
  return number && std::abs(*number) <= kLargest ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

/// A port as a whole, or a number of what is at the port or, without one, at the expander.
void hold(Place& place, const Value& entry, const Model& model, const Member& row) {
  const std::string where = place.port.empty() ? text_in(entry, "pwm") : place.port;
  if (where.empty()) return;
  if (row.kind == Member::Kind::port) {
    if (!place.port.empty()) place.holds.push_back({fmt::format("{} '{}'", row.holds, place.port), row.name});
  } else if (const auto number = number_in(entry, model, row.name.c_str())) {
    place.holds.push_back({fmt::format("{} {} of '{}'", row.holds, *number, where), row.name});
  }
}

}  // namespace

Place place_of(const Value& entry, const Model& model) {
  Place place;
  place.port = text_in(entry, "port");
  for (const Member& row : model.figures) {
    if (!row.holds.empty()) hold(place, entry, model, row);
  }
  if (find_member(model.figures, "mux") == nullptr) return place;
  place.mux = text_in(entry, "mux");
  const auto channel = number_in(entry, model, "channel");
  if (!place.port.empty()) place.bus = fmt::format("'{}'", place.port);
  if (!place.mux.empty() && channel) place.bus = fmt::format("channel {} of '{}'", *channel, place.mux);
  place.address = number_in(entry, model, "address");
  return place;
}

}  // namespace finemote::scenario
