// Words of the URDF that ROS tools skip silently: FM3084 is an error where what a device needs would be computed
// without what was meant, else a warning like FM3085.
#include <fmt/format.h>

#include <algorithm>

#include "generator/geometry/mechanism.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/reading.hpp"

namespace finemote::gen {
namespace {

/// The joints from the root to a link; none where they do not end, which is reported.
std::vector<const Joint*> way_to(const Mechanism& mechanism, const std::string& link) {
  return mechanism.way_to(link).value_or(std::vector<const Joint*>{});
}

/// The link whose place the device depends on; empty: none.
std::string place_of(const Reading& reading, DeviceId device) {
  const Joint* joint = reading.kinematics.joint(value_of(reading.device_tag(device), "joint"));
  return joint != nullptr ? joint->child_link : std::string(value_of(reading.device_tag(device), "link"));
}

bool weighs(const Device& device) {
  return device.type != nullptr && std::any_of(device.type->geometry.begin(), device.type->geometry.end(),
                                               [](const GeometrySpec& geometry) { return geometry.kind == "chain"; });
}

/// The first device that what is computed for depends on the joint or link of the doubt.
const Device* first_user(const Reading& reading, const Mechanism& mechanism, const Doubt& doubt) {
  for (const DeviceId i : reading.robot.devices.ids()) {
    const Device& device = reading.robot.devices[i];
    if (doubt.joint.empty() && weighs(device)) return &device;
    const std::vector<const Joint*> way = way_to(mechanism, place_of(reading, i));
    const bool is_on_way =
        std::any_of(way.begin(), way.end(), [&](const Joint* joint) { return joint->name == doubt.joint; });
    if (is_on_way) return &device;
  }
  return nullptr;
}

}  // namespace

bool is_place_known(const Reading& reading, const Mechanism& mechanism, const std::string& link) {
  const std::vector<const Joint*> way = way_to(mechanism, link);
  return std::none_of(way.begin(), way.end(),
                      [&](const Joint* joint) { return reading.kinematics.wrong_joints.count(joint->name) > 0; });
}

void judge_doubts(Reading& reading) {
  Kinematics& kinematics = reading.kinematics;
  const Mechanism mechanism(kinematics.links, kinematics.joints);
  std::vector<Doubt> harmless;
  for (Doubt& doubt : kinematics.doubts) {
    const Device* user = doubt.is_missing ? first_user(reading, mechanism, doubt) : nullptr;
    if (user == nullptr) {
      harmless.push_back(std::move(doubt));
      continue;
    }
    doubt.finding.severity = Severity::error;
    reading.diagnostics.add(doubt.finding.note(fmt::format("device '{}' depends on it", user->name.text), user->at));
    (doubt.joint.empty() ? kinematics.wrong_links : kinematics.wrong_joints)
        .insert(doubt.joint.empty() ? doubt.link : doubt.joint);
  }
  kinematics.doubts = std::move(harmless);
}

}  // namespace finemote::gen
