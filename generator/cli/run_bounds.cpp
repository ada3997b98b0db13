#include "generator/cli/run_bounds.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>

#include "generator/diagnostic/code_scenario.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 4> kParts = {"acquire", "decide", "wire", "end_to_end"};

/// A member of whatever a file holds; null where there is none.
const Json& held_in(const Json& value, const std::string& name) {
  static const Json kNone;
  const auto found = value.is_object() ? value.find(name) : value.end();
  return found == value.end() ? kNone : *found;
}

const Json* chain_like(const Json& chains, const Json& wanted) {
  for (const Json& chain : chains) {
    if (chain["from"] == held_in(wanted, "from") && chain["to"] == held_in(wanted, "to")) return &chain;
  }
  return nullptr;
}

std::string time_text(const Json& ns) {
  return ns.is_number_integer() ? units::format_duration(nanoseconds(ns.get<std::int64_t>())) : "none";
}

/// What differs first; none where nothing does, as far as the run says what it was judged by.
std::optional<std::string> first_difference(const Json& run, const Json& timing) {
  for (const Json& judged : held_in(run, "chains")) {
    const Json* now = chain_like(timing["chains"], judged);
    for (const char* part : kParts) {
      const Json& then = held_in(held_in(judged, part), "bound_ns");
      if (now == nullptr || !then.is_number_integer()) continue;
      const Json& bound = (*now)[std::string(part) + "_ns"];
      if (bound == then) continue;
      return fmt::format("{} of {} -> {} was held to {}, and has a bound of {} now", part,
                         (*now)["from"].get<std::string>(), (*now)["to"].get<std::string>(), time_text(then),
                         time_text(bound));
    }
  }
  return std::nullopt;
}

}  // namespace

void check_bounds_of_run(const Json& run, const std::string& path, const Json& timing, Diagnostics& diagnostics) {
  const bool is_comparable = timing["profile"] == "target";  // which a run is held to
  const auto difference = is_comparable ? first_difference(run, timing) : std::nullopt;
  if (!difference) return;
  diagnostics
      .warning(code::other_bounds, {},
               fmt::format("the run in '{}' is of the robot in another state: its bounds were others", path))
      .note(*difference)
      .hint("run the robot as it is: finemote run IN --format json > run.json");
}

}  // namespace finemote::gen
