// `link` and `joint` of devices against the URDF: FM2002 to FM2004, FM2006.
#include <fmt/format.h>

#include <algorithm>

#include "generator/model/attributes.hpp"
#include "generator/model/reading.hpp"

namespace finemote::gen {
namespace {

template <typename Entry>
std::vector<std::string> names_of(const std::vector<Entry>& list) {
  std::vector<std::string> names;
  for (const Entry& entry : list) names.push_back(entry.name);
  return names;
}

void check_link(Reading& reading, const xml::Node& tag) {
  const xml::Attribute* link = tag.attribute("link");
  if (link == nullptr || reading.kinematics.link(link->value) != nullptr) return;
  suggest(at_value(reading.diagnostics, code::unknown_link, *link, fmt::format("there is no link '{}'", link->value)),
          link->value, names_of(reading.kinematics.links));
}

void check_joint(Reading& reading, const Device& device, const xml::Node& tag) {
  const xml::Attribute* name = tag.attribute("joint");
  if (name == nullptr) return;
  const Joint* joint = reading.kinematics.joint(name->value);
  if (joint == nullptr) {
    suggest(
        at_value(reading.diagnostics, code::unknown_joint, *name, fmt::format("there is no joint '{}'", name->value)),
        name->value, names_of(reading.kinematics.joints));
    return;
  }
  const bool must_move = device.type != nullptr && device.type->actuator;
  if (!must_move || joint->type != "fixed") return;
  at_value(reading.diagnostics, code::joint_fixed, *name,
           fmt::format("joint '{}' is fixed, but device '{}' moves it", name->value, device.name.text))
      .note("the joint stands here", joint->at)
      .hint("make the joint type=\"continuous\" for what spins, \"revolute\" or \"prismatic\" for what has an end");
}

std::string joint_hint(const Reading& reading) {
  const std::vector<std::string> free = free_joints(reading);
  if (free.empty()) return "add joint=\"...\" with the name of the joint it moves; all joints that move are taken";
  std::string others;
  for (std::size_t i = 1; i < free.size(); ++i) others += fmt::format("{}'{}'", i > 1 ? ", " : "", free[i]);
  return fmt::format("add joint=\"{}\"{}", free.front(),
                     others.empty() ? ", the only one that moves and that no device drives"
                                    : ", or another that no device drives: " + others);
}

/// Children that geometry is computed of have to say which joint they drive.
void check_geometry(Reading& reading, const Device& parent) {
  for (const GeometrySpec& geometry : parent.type->geometry) {
    for (const std::size_t child : parent.children) {
      const Device& device = reading.robot.devices[child];
      const bool is_meant = device.role && parent.type->roles[*device.role].name == geometry.role;
      if (!is_meant || !device.joint.empty() || reading.device_tag(child).attribute("joint") != nullptr) continue;
      at_tag(reading.diagnostics, code::joint_needed, reading.device_tag(child),
             fmt::format("device '{}' has no 'joint'", device.name.text))
          .note(fmt::format("the {} of device '{}' is computed from origin and axis of the joints of its {}",
                            geometry.kind, parent.name.text, geometry.role))
          .hint(joint_hint(reading));
    }
  }
}

}  // namespace

std::vector<std::string> free_joints(const Reading& reading) {
  std::vector<std::string> free;
  for (const Joint& joint : reading.kinematics.joints) {
    const bool is_driven = std::any_of(reading.robot.devices.begin(), reading.robot.devices.end(),
                                       [&](const Device& device) { return device.joint == joint.name; });
    if (joint.type != "fixed" && !is_driven) free.push_back(joint.name);
  }
  return free;
}

void check_joints(Reading& reading) {
  for (std::size_t i = 0; i < reading.robot.devices.size(); ++i) {
    const Device& device = reading.robot.devices[i];
    check_link(reading, reading.device_tag(i));
    check_joint(reading, device, reading.device_tag(i));
    if (device.type != nullptr) check_geometry(reading, device);
  }
}

}  // namespace finemote::gen
