// `link` and `joint` of devices against the URDF: FM2002 to FM2004, FM2006.
#include <fmt/format.h>

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
          .hint("add joint=\"...\"");
    }
  }
}

}  // namespace

void check_joints(Reading& reading) {
  for (std::size_t i = 0; i < reading.robot.devices.size(); ++i) {
    const Device& device = reading.robot.devices[i];
    check_link(reading, reading.device_tag(i));
    check_joint(reading, device, reading.device_tag(i));
    if (device.type != nullptr) check_geometry(reading, device);
  }
}

}  // namespace finemote::gen
