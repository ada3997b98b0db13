#include "generator/report/body.hpp"

#include <set>
#include <utility>

#include "generator/geometry/mechanism.hpp"
#include "generator/model/device_frames.hpp"

namespace finemote::gen::report {
namespace {

/// Joints by which some device of the robot pushes.
std::set<std::string> pushing_joints(const Robot& robot) {
  std::set<std::string> joints;
  for (const Device& device : robot.devices) {
    for (const GeometrySpec& geometry : device.type->geometry) {
      if (geometry.kind != "allocation") continue;
      const std::vector<std::string> of_role = role_joints(robot, device, geometry);
      joints.insert(of_role.begin(), of_role.end());
    }
  }
  return joints;
}

std::optional<Body::Part> part_of(const Device& device, const Mechanism& mechanism, const std::string& base) {
  Body::Part part;
  part.device = device.name.text;
  if (!device.joint.empty()) {
    const auto axis = joint_axis(mechanism, device.joint, base);
    if (!axis) return std::nullopt;
    part.at = "joint '" + device.joint + "'";
    part.point = axis->point;
    part.axis = axis->direction;
    return part;
  }
  if (device.link.empty()) return std::nullopt;
  const auto pose = mechanism.pose(device.link, base);
  if (!pose) return std::nullopt;
  part.at = "link '" + device.link + "'";
  part.point = pose->translation();
  return part;
}

}  // namespace

Body body_of(const Robot& robot) {
  const Mechanism mechanism(robot.links, robot.joints);
  Body body;
  body.base = mechanism.base();
  for (const Joint& joint : robot.joints) {
    const auto from = mechanism.pose(joint.parent_link, body.base), to = mechanism.pose(joint.child_link, body.base);
    if (from && to) body.bones.push_back({from->translation(), to->translation()});
  }
  const std::set<std::string> pushing = pushing_joints(robot);
  for (const Device& device : robot.devices) {
    auto part = part_of(device, mechanism, body.base);
    if (!part) continue;
    part->pushes = part->axis && pushing.count(device.joint) > 0;
    if (part->pushes) body.authority += part->axis->cwiseAbs();
    body.parts.push_back(std::move(*part));
  }
  return body;
}

}  // namespace finemote::gen::report
