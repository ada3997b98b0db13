#include "generator/geometry/role_joints.hpp"

namespace finemote::gen {

std::vector<std::string> role_joints(const Robot& robot, const Device& device, const GeometrySpec& geometry) {
  std::vector<std::string> joints;
  for (const std::size_t index : device.children) {
    const Device& child = robot.devices[index];
    const bool is_meant = child.role && device.type->roles[*child.role].name == geometry.role;
    if (is_meant && !child.joint.empty()) joints.push_back(child.joint);
  }
  return joints;
}

}  // namespace finemote::gen
