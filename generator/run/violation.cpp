#include "generator/run/violation.hpp"

#include <algorithm>

#include "generator/bus/bus_type.hpp"

namespace finemote::gen {
namespace {

constexpr const char* kBusErrors = "bus-errors";

std::optional<BusId> bus_of(const Robot& robot, const std::optional<SegmentId>& segment) {
  return segment ? std::optional(robot.segments[*segment].bus) : std::nullopt;
}

/// A part is called like its device or expander, one at a further line of a device `device.role`.
std::optional<BusId> bus_of_part(const Robot& robot, const std::string& part) {
  for (const Device& device : robot.devices) {
    if (device.name.text == part) return bus_of(robot, device.segment);
    for (const Use& use : device.uses) {
      if (device.name.text + "." + use.spec->role == part) return bus_of(robot, use.segment);
    }
  }
  for (const Expander& expander : robot.expanders) {
    if (expander.name.text == part) return bus_of(robot, expander.segment);
  }
  return std::nullopt;
}

std::optional<BusId> bus_at(const Robot& robot, const std::string& port) {
  for (const BusId bus : robot.buses.ids()) {
    if (robot.buses[bus].port == port) return bus;
  }
  return std::nullopt;
}

bool uses_bus(const Robot& robot, const std::optional<DeviceId>& device, BusId bus) {
  if (!device) return false;
  const Device& one = robot.devices[*device];
  return bus_of(robot, one.segment) == bus || std::any_of(one.uses.begin(), one.uses.end(), [&](const Use& use) {
           return bus_of(robot, use.segment) == bus;
         });
}

/// Nothing but the data that go over the bus is touched: no job recovers it.
bool is_local(const Robot& robot, const Violation& violation) {
  return violation.assumption == kBusErrors && violation.bus &&
         !bus_type(robot.buses[*violation.bus].kind).bus_class.supervised;
}

}  // namespace

Violation violation_of(const std::string& assumption, const std::string& part, const std::string& port,
                       const Robot& robot) {
  return {assumption, !part.empty() ? bus_of_part(robot, part) : !port.empty() ? bus_at(robot, port) : std::nullopt};
}

std::vector<std::string> assumptions_of(const std::vector<Violation>& violations) {
  std::vector<std::string> all;
  for (const Violation& violation : violations) {
    if (std::find(all.begin(), all.end(), violation.assumption) == all.end()) all.push_back(violation.assumption);
  }
  return all;
}

Journey journey_of(const MeasuredChain& chain, Measured MeasuredChain::*figure) {
  const bool is_whole = figure == &MeasuredChain::end_to_end;
  Journey journey;
  if (is_whole || figure == &MeasuredChain::acquire) journey.sampled = chain.from;
  if (is_whole || figure == &MeasuredChain::wire) journey.commanded = chain.to;
  return journey;
}

std::optional<std::string> violated_assumption(const Robot& robot, const std::vector<Violation>& violations,
                                               const Journey& journey) {
  for (const Violation& violation : violations) {
    const bool is_touched = !is_local(robot, violation) || uses_bus(robot, journey.sampled, *violation.bus) ||
                            uses_bus(robot, journey.commanded, *violation.bus);
    if (is_touched) return violation.assumption;
  }
  return std::nullopt;
}

}  // namespace finemote::gen
