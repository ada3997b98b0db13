// `link` and `joint` of devices against the URDF: FM2002 to FM2004, FM2006, FM2011.
#include <fmt/format.h>

#include <algorithm>

#include "generator/geometry/chain.hpp"
#include "generator/geometry/rolling.hpp"
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

const char* what_is_computed(const GeometrySpec& geometry) {
  if (geometry.kind == "rolling") return "rolling of the wheels";
  if (geometry.kind == "chain") return "weight on the joints";
  if (geometry.kind == "axes") return "way of turning";
  return "allocation";
}

/// Children of the role, those with a mistake of their own included.
std::vector<std::size_t> children_in(const Reading& reading, const Device& parent, const std::string& role) {
  std::vector<std::size_t> children;
  for (const std::size_t child : parent.children) {
    const Device& device = reading.robot.devices[child];
    if (device.role && parent.type->roles[*device.role].name == role) children.push_back(child);
  }
  return children;
}

/// Children that geometry is computed of have to say which joint they drive. @return they all do
bool check_joints_named(Reading& reading, const Device& parent, const GeometrySpec& geometry,
                        const std::vector<std::size_t>& children) {
  bool all = true;
  for (const std::size_t child : children) {
    const Device& device = reading.robot.devices[child];
    all = all && reading.kinematics.joint(device.joint) != nullptr;
    if (!device.joint.empty() || reading.device_tag(child).attribute("joint") != nullptr) continue;
    at_tag(reading.diagnostics, code::joint_needed, reading.device_tag(child),
           fmt::format("device '{}' has no 'joint'", device.name.text))
        .note(fmt::format("the {} of device '{}' is computed from origin and axis of the joints of its {}",
                          what_is_computed(geometry), parent.name.text, geometry.role))
        .hint(joint_hint(reading));
  }
  return all;
}

std::string geometry_problem(const Reading& reading, const GeometrySpec& geometry,
                             const std::vector<std::string>& joints, std::size_t index) {
  const Mechanism mechanism(reading.kinematics.links, reading.kinematics.joints);
  const auto axis = joint_axis(mechanism, joints[index]);
  if (!axis) return {};  // a chain without end, or no axis: reported
  if (geometry.kind == "rolling") return wheel_problem(*axis);
  if (geometry.kind == "chain") return chain_problem(mechanism, joints, index);
  return {};
}

void check_joints_fit(Reading& reading, const Device& parent, const GeometrySpec& geometry,
                      const std::vector<std::size_t>& children) {
  std::vector<std::string> joints;
  for (const std::size_t child : children) joints.push_back(reading.robot.devices[child].joint);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const std::string problem = geometry_problem(reading, geometry, joints, i);
    if (problem.empty()) continue;
    const Device& device = reading.robot.devices[children[i]];
    Diagnostic& finding =
        at_value(reading.diagnostics, code::joint_unfit, *reading.device_tag(children[i]).attribute("joint"),
                 fmt::format("joint '{}' cannot be one of the {} of device '{}'", device.joint, geometry.role,
                             parent.name.text));
    finding.note(problem).note("the joint stands here", reading.kinematics.joint(device.joint)->at);
    if (geometry.kind == "chain") finding.hint("declare turning joints, base to tip");
  }
}

void check_geometry(Reading& reading, const Device& parent) {
  for (const GeometrySpec& geometry : parent.type->geometry) {
    if (geometry.role.empty()) continue;
    const std::vector<std::size_t> children = children_in(reading, parent, geometry.role);
    const bool none = std::all_of(children.begin(), children.end(), [&](std::size_t child) {
      return reading.device_tag(child).attribute("joint") == nullptr;
    });
    if (geometry.optional && none) continue;
    if (check_joints_named(reading, parent, geometry, children)) check_joints_fit(reading, parent, geometry, children);
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
