#include "generator/run/emulation.hpp"

namespace finemote::gen {

std::vector<const Device*> actuators_in(const Robot& robot, const Device& device) {
  if (has_part(device)) return device.type->actuator ? std::vector{&device} : std::vector<const Device*>();
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
