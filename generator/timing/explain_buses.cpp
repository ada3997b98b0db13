// FM4021: who overloads a bus, and what makes room.
#include <fmt/format.h>

#include "generator/timing/explain.hpp"
#include "generator/timing/shares.hpp"
#include "generator/timing/words.hpp"

namespace finemote::gen::timing {
namespace {

constexpr double kGoodBusLoad = 0.7;  ///< what hints aim at: that of lint

/// What makes room on a bus: a faster rate, or fewer messages of ours. What the parts send by themselves is not up to
/// this file.
void add_room_hints(const Timing& timing, BusPlace bus, Trials& trials, Diagnostic& finding) {
  const Goal goal{[bus](const Timing& t) { return t.bus_loads[bus].utilization; }, kGoodBusLoad};
  const std::vector<Family> families{
      longer_periods(timing.model, periodic_users(timing.model, bus), "what sends on it"),
      faster_rates(timing.model, bus), other_bus(timing.model, bus)};
  for (const Remedy& remedy : trials.find(families, goal)) {
    finding.hint(fmt::format("{} brings it from {} to {}{}", remedy.proposal.text,
                             percent(timing.bus_loads[bus].utilization), percent(remedy.value),
                             remedy.enough || remedy.value <= 1 ? "" : ", which is not enough alone"));
  }
}

}  // namespace

void report_bus_overloads(const Timing& timing, Trials& trials, Diagnostics& diagnostics) {
  for (const BusPlace b : timing.bus_loads.ids()) {
    const double load = timing.bus_loads[b].utilization;
    if (load <= 1) continue;
    Diagnostic& finding = diagnostics.warning(code::timing_bus_overload, timing.model.buses[b].at,
                                              fmt::format("bus '{}' is overloaded: it needs {} of its capacity",
                                                          timing.model.buses[b].name, whole_percent(load)));
    finding.underline(4).note(shares_text(bus_shares(timing.model, b)));
    finding.note("messages are lost or late, and no latency over the bus has a bound");
    add_room_hints(timing, b, trials, finding);
  }
}

}  // namespace finemote::gen::timing
