#include "generator/run/check_routines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "generator/bus/bus_type.hpp"
#include "generator/image/exception.hpp"
#include "generator/run/pin_lines.hpp"
#include "generator/tasks/robot_buses.hpp"
#include "generator/timing/analyse.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

/// The longest run of a routine; 0: it never ran.
Duration longest_of(const RunRecord& record, std::uint32_t exception) {
  const auto found = std::find_if(record.routine_times.begin(), record.routine_times.end(),
                                  [&](const RoutineTime& routine) { return routine.exception == exception; });
  return found == record.routine_times.end() ? Duration::zero() : found->longest;
}

/// Frames that a receive FIFO of bxCAN holds: RM0090 32.7.3.
constexpr std::int64_t kReceiveFifo = 3;

/// Frames that one run may receive, of which each counts as a run.
std::int64_t frames_at_once(const Bus& bus, const InterruptLine& line) {
  const bool receives = line.name.find("_RX") != std::string::npos;
  return receives && bus_type(bus.kind).is_arbitrated ? kReceiveFifo : 1;
}

/// What one run of a routine of the bus counts for at most: it may serve all its causes at once, or on CAN as many
/// frames as a receive FIFO holds.
Duration longest_counted(const timing::Bus& bus) {
  const std::int64_t at_once = bus.arbitrated ? kReceiveFifo : 1;
  if (!bus.sources) return at_once * bus.wcet;
  Duration longest, sum;
  for (const timing::InterruptSource& source : *bus.sources) {
    longest = std::max(longest, (source.name == "request" ? 1 : at_once) * source.wcet);  // one has all its frames
    if (!source.steals) sum += source.wcet;
  }
  return std::max(longest, sum);
}

/// @param who  whose routine it is, in words
bool check_counted(const std::string& who, Duration seen, Duration counted, const Position& at,
                   Diagnostics& diagnostics) {
  if (seen <= counted) return true;
  diagnostics
      .error(code::wcet_exceeded, at,
             fmt::format("{} took {} us by itself, entry and exit included, and the analysis counts {} us", who,
                         seen.ns() / 1000.0, counted.ns() / 1000.0))
      .note("its figure is that of the timing file or, without one, of the board file: the bounds rest on it");
  return false;
}

bool check_declared(const std::string& who, Duration seen, Duration allowed, const Bus& bus, Diagnostics& diagnostics) {
  if (seen <= allowed) return true;
  diagnostics
      .error(code::wcet_exceeded, bus.at,
             fmt::format("{} took {} us by itself, entry and exit included, its isr_wcet is {}", who,
                         seen.ns() / 1000.0, units::format_duration(*bus.isr_wcet)))
      .hint("leave isr_wcet out: then the figures of the driver count");
  return false;
}

/// @param is_declared  the bounds rest on the robot's `isr_wcet`
bool check_bus(const Bus& bus, const Port& port, const timing::Bus& counted, bool is_declared,
               const timing::Model& model, const RunRecord& record, Diagnostics& diagnostics) {
  bool holds = true;
  for (const InterruptLine& line : port.interrupts) {
    const std::string who = fmt::format("bus '{}': its routine for {}", bus.name.text, line.name);
    const Duration seen = longest_of(record, exception_of(line.number));
    const Duration wcet = is_declared ? frames_at_once(bus, line) * *bus.isr_wcet : longest_counted(counted);
    const Duration allowed = wcet + model.costs.interrupt;
    holds = (is_declared ? check_declared(who, seen, allowed, bus, diagnostics)
                         : check_counted(who, seen, allowed, bus.at, diagnostics)) &&
            holds;
  }
  return holds;
}

bool check_release(const timing::Model& model, const RunRecord& record, Diagnostics& diagnostics) {
  std::set<Duration> periods;
  for (const timing::Device& device : model.devices) periods.insert(device.period);
  const Duration counted =
      model.costs.release + static_cast<std::int64_t>(periods.size()) * model.costs.release_per_bucket;
  return check_counted("the release interrupt", longest_of(record, kSysTickException), counted,
                       timing::at_first_device(model), diagnostics);
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
  if (!line.is_assumed || seen <= line.wcet + model.costs.interrupt) return true;
  diagnostics
      .error(code::wcet_exceeded, line.at,
             fmt::format("the routine for the pins of {} took {} us by itself, entry and exit included, where {} are "
                         "declared or assumed",
                         line.devices, seen.ns() / 1000.0, units::format_duration(line.wcet)))
      .hint("let \"wcet_ns\" of \"interrupts\" in the descriptor say how long it takes");
  return false;
}

/// Whether what the analysis counts has to hold in this run: what faults and missing parts make drivers do takes
/// longer, and so does every fetch that misses where times were not computed from the image (assumption `flash`).
bool counts(const timing::Model& model, const RunRecord& record) {
  const bool hits = record.flash != "miss" || model.costs.source == timing::WcetSource::computed;
  return hits && record.violated.empty() && record.silent.empty() && record.absent.empty();
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
    if (port == nullptr || !place) continue;
    const timing::Bus& counted = model.buses[*place];
    const bool declares = bus.isr_wcet && is_declared(counted);
    if (declares || counts(model, record))
      holds = check_bus(bus, *port, counted, declares, model, record, diagnostics) && holds;
  }
  if (counts(model, record)) holds = check_release(model, record, diagnostics) && holds;
  for (const PinLine& line : pin_lines(robot, model, record.traffic_window))
    holds = check_pins(line, model, record, diagnostics) && holds;
  return holds;
}

}  // namespace finemote::gen
