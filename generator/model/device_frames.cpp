#include "generator/model/device_frames.hpp"

#include <algorithm>

#include "generator/geometry/frame.hpp"

namespace finemote::gen {

std::vector<std::string> role_joints(const Robot& robot, const Device& device, const GeometrySpec& geometry) {
  std::vector<std::string> joints;
  for (const DeviceId id : device.children) {
    const Device& child = robot.devices[id];
    const bool is_meant = child.role && device.type->roles[*child.role].name == geometry.role;
    if (is_meant && !child.joint.empty()) joints.push_back(child.joint);
  }
  return joints;
}

std::string reference_link(const Robot& robot, const Device& device) {
  const Mechanism mechanism(robot.links, robot.joints);
  for (const GeometrySpec& geometry : device.type->geometry) {
    const std::vector<std::string> joints = role_joints(robot, device, geometry);
    if (!joints.empty()) return geometry_link(mechanism, device.link, geometry, joints);
  }
  return device.children.empty() ? std::string() : device.link;
}

std::string mount_link(const Robot& robot, DeviceId part) {
  for (auto above = robot.devices[part].parent; above; above = robot.devices[*above].parent) {
    const std::string link = reference_link(robot, robot.devices[*above]);
    if (!link.empty()) return link;
  }
  for (const Device& device : robot.devices) {
    const bool reads =
        std::any_of(device.reads.begin(), device.reads.end(), [&](const Read& read) { return read.device == part; });
    const std::string link = reads ? reference_link(robot, device) : std::string();
    if (!link.empty()) return link;
  }
  return Mechanism(robot.links, robot.joints).body();
}

}  // namespace finemote::gen
