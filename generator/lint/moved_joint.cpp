#include "generator/lint/moved_joint.hpp"

#include <algorithm>

namespace finemote::gen {
namespace {

/// What turns a joint, itself or by a joint it follows; null: nothing does.
const Device* mover_of(const Robot& robot, const Joint& joint) {
  const std::string& driven = joint.mimic.empty() ? joint.name : joint.mimic;
  const auto found = std::find_if(robot.devices.begin(), robot.devices.end(), [&](const Device& device) {
    return device.joint == driven && (device.type->actuator || device.type->has_command());
  });
  return found == robot.devices.end() ? nullptr : &*found;
}

}  // namespace

std::optional<MovedJoint> moved_between(const CheckedGeometry& checked, const std::string& link,
                                        const std::string& other) {
  const auto way = checked.mechanism.way_to(link), way_other = checked.mechanism.way_to(other);
  if (!way || !way_other) return std::nullopt;
  const auto shared = std::mismatch(way->begin(), way->end(), way_other->begin(), way_other->end());
  std::vector<const Joint*> between(shared.first, way->end());
  between.insert(between.end(), shared.second, way_other->end());
  for (const Joint* joint : between) {
    if (const Device* mover = mover_of(checked.robot, *joint); mover != nullptr) return MovedJoint{joint, mover};
  }
  return std::nullopt;
}

}  // namespace finemote::gen
