#include "generator/run/emulation.hpp"

namespace finemote::gen {

namespace {

/// Nothing between the segment and the board is without a model.
bool is_wired(const Robot& robot, SegmentId segment) {
  const std::optional<ExpanderId> expander = robot.segments[segment].expander;
  return !expander || has_part(robot, robot.expanders[*expander]);
}

}  // namespace

bool has_part(const Robot& robot, const Device& device) {
  return device.segment && !device.type->emulation.part.empty() && is_wired(robot, *device.segment);
}

bool has_part(const Robot& robot, const Expander& expander) {
  return !expander.type->emulation.part.empty() && is_wired(robot, expander.segment);
}

std::vector<const Device*> actuators_in(const Robot& robot, const Device& device) {
  if (has_part(robot, device)) return device.type->actuator ? std::vector{&device} : std::vector<const Device*>();
  std::vector<const Device*> all;
  for (const DeviceId child : device.children) {
    const auto inside = actuators_in(robot, robot.devices[child]);
    all.insert(all.end(), inside.begin(), inside.end());
  }
  return all;
}

std::string driven_joint(const Robot& robot, const Device& device) {
  const Device* at = &device;
  while (at->joint.empty() && at->parent) {
    at = &robot.devices[*at->parent];
    if (actuators_in(robot, *at).size() != 1) return {};
  }
  return at->joint;
}

}  // namespace finemote::gen
