#include "generator/run/check_routines.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/bus/bus_type.hpp"
#include "generator/image/exception.hpp"
#include "generator/run/pin_lines.hpp"
#include "generator/tasks/robot_buses.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

/// The longest run of a routine; 0: it never ran.
Duration longest_of(const RunRecord& record, std::uint32_t exception) {
  const auto found = std::find_if(record.routine_times.begin(), record.routine_times.end(),
                                  [&](const RoutineTime& routine) { return routine.exception == exception; });
  return found == record.routine_times.end() ? Duration::zero() : found->longest;
}

/// What a run may take that the model says takes this long: entry and exit are in what was seen.
bool is_above(Duration seen, Duration wcet, const timing::Model& model) { return seen > wcet + model.costs.interrupt; }

/// Frames that one run may receive, of which each counts as a run: as many as a mailbox of bxCAN keeps (RM0090 32.7.4).
std::int64_t frames_at_once(const Bus& bus, const InterruptLine& line) {
  const bool receives = line.name.find("_RX") != std::string::npos;
  return receives && bus_type(bus.kind).is_arbitrated ? 3 : 1;
}

bool check_bus(const Bus& bus, const Port& port, const timing::Model& model, const RunRecord& record,
               Diagnostics& diagnostics) {
  bool holds = true;
  for (const InterruptLine& line : port.interrupts) {
    const Duration seen = longest_of(record, exception_of(line.number));
    if (!is_above(seen, frames_at_once(bus, line) * *bus.isr_wcet, model)) continue;
    holds = false;
    diagnostics
        .error(code::wcet_exceeded, bus.at,
               fmt::format(
                   "bus '{}': its routine for {} took {} us by itself, entry and exit included, its isr_wcet is {}",
                   bus.name.text, line.name, seen.ns() / 1000.0, units::format_duration(*bus.isr_wcet)))
        .hint("leave isr_wcet out: then the figures of the driver count");
  }
  return holds;
}

/// Whether the bounds rest on what the robot says of the routines of its bus.
bool is_declared(const timing::Bus& bus) {
  return bus.sources &&
         std::any_of(bus.sources->begin(), bus.sources->end(), [](const timing::InterruptSource& source) {
           return source.source == timing::WcetSource::declared;
         });
}

bool check_pins(const PinLine& line, const timing::Model& model, const RunRecord& record, Diagnostics& diagnostics) {
  const Duration seen = longest_of(record, line.exception);
  if (!line.is_assumed || !is_above(seen, line.wcet, model)) return true;
  diagnostics
      .error(code::wcet_exceeded, line.at,
             fmt::format("the routine for the pins of {} took {} us by itself, entry and exit included, where {} are "
                         "declared or assumed",
                         line.devices, seen.ns() / 1000.0, units::format_duration(line.wcet)))
      .hint("let \"wcet_ns\" of \"interrupts\" in the descriptor say how long it takes");
  return false;
}

}  // namespace

bool check_routines(const Robot& robot, const timing::Model& model, const RunRecord& record, Diagnostics& diagnostics) {
  if (robot.board == nullptr || record.routine_times.empty()) return true;
  const timing::BusPlaces places(robot);
  bool holds = true;
  for (const BusId id : robot.buses.ids()) {
    const Bus& bus = robot.buses[id];
    const Port* port = robot.board->port(bus.port);
    const auto place = places.of(id);
    if (!bus.isr_wcet || port == nullptr || !place || !is_declared(model.buses[*place])) continue;
    holds = check_bus(bus, *port, model, record, diagnostics) && holds;
  }
  for (const PinLine& line : pin_lines(robot, model, record.traffic_window))
    holds = check_pins(line, model, record, diagnostics) && holds;
  return holds;
}

}  // namespace finemote::gen
