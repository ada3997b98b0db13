#include "generator/lint/sensor_rules.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/geometry/frame.hpp"
#include "generator/lint/moved_joint.hpp"

namespace finemote::gen {
namespace {

/// A sensor that says where its link is, and whose data depend on how it is turned.
struct MountedSensor {
  const Device& device;
  const std::string& role;  ///< what it is to the device that reads it
};

bool is_mounted(const Device& device) {
  const auto& all = device.type->geometry;
  return !device.link.empty() &&
         std::any_of(all.begin(), all.end(), [](const GeometrySpec& spec) { return spec.kind == "mount"; });
}

std::vector<MountedSensor> mounted_sensors(const Robot& robot, const Device& device) {
  std::vector<MountedSensor> sensors;
  const auto visit = [&](DeviceId index, std::size_t role) {
    const Device& sensor = robot.devices[index];
    if (is_mounted(sensor)) sensors.push_back({sensor, device.type->roles[role].name});
  };
  for (const DeviceId child : device.children) {
    if (robot.devices[child].role) visit(child, *robot.devices[child].role);
  }
  for (const Read& read : device.reads) visit(read.device, read.role);
  return sensors;
}

void check_fixed_to_body(const CheckedGeometry& checked, const MountedSensor& sensor, Findings& findings) {
  const auto moved = moved_between(checked, sensor.device.link, checked.link);
  if (!moved) return;
  findings
      .add(sensor.device,
           fmt::format("joint '{}' moves device '{}', the {} of device '{}', against the body", moved->joint->name,
                       sensor.device.name.text, sensor.role, checked.device.name.text))
      .note(fmt::format("the body is link '{}'", checked.link))
      .note(fmt::format("device '{}' drives the joint", moved->mover->name.text), moved->mover->at)
      .hint(fmt::format("use a sensor that is fixed to link '{}'", checked.link));
}

void check_carried(const CheckedGeometry& checked, const MountedSensor& sensor, Findings& findings) {
  const std::string& last = checked.joints.back();
  const auto way = checked.mechanism.way_to(sensor.device.link);
  const bool is_carried =
      way && std::any_of(way->begin(), way->end(), [&](const Joint* joint) { return joint->name == last; });
  if (is_carried) return;
  findings
      .add(sensor.device,
           fmt::format("device '{}', the {} of device '{}', is not on what the {} turns", sensor.device.name.text,
                       sensor.role, checked.device.name.text, checked.geometry.role))
      .note(fmt::format("its link '{}' is not behind joint '{}'", sensor.device.link, last))
      .hint(fmt::format("write link=\"{}\" if it is there, or hang its link on that one",
                        checked.joint(last).child_link));
}

}  // namespace

void find_misplaced_sensors(const CheckedGeometry& checked, Findings& findings) {
  if (checked.joints.empty()) return;
  for (const MountedSensor& sensor : mounted_sensors(checked.robot, checked.device)) {
    if (is_about_body(checked.geometry)) check_fixed_to_body(checked, sensor, findings);
    const bool is_carrying = checked.geometry.kind == "axes" && checked.geometry.carries == sensor.role;
    if (is_carrying) check_carried(checked, sensor, findings);
  }
}

}  // namespace finemote::gen
