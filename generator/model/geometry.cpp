// What a device's type computes of the URDF against the joints of its children: FM2006, FM2011, FM2014, FM2015.
#include <fmt/format.h>

#include <algorithm>

#include "generator/geometry/fit.hpp"
#include "generator/geometry/frame.hpp"
#include "generator/geometry/range.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/reading.hpp"

namespace finemote::gen {
namespace {

const char* what_is_computed(const GeometrySpec& geometry) {
  if (geometry.kind == "rolling") return "rolling of the wheels";
  if (geometry.kind == "chain") return "weight on the joints";
  if (geometry.kind == "axes") return "way of turning";
  if (geometry.kind == "range") return "range";
  return "allocation";
}

/// Children of the role, those with a mistake of their own included.
std::vector<DeviceId> children_in(const Reading& reading, const Device& parent, const std::string& role) {
  std::vector<DeviceId> children;
  for (const DeviceId child : parent.children) {
    const Device& device = reading.robot.devices[child];
    if (device.role && parent.type->roles[*device.role].name == role) children.push_back(child);
  }
  return children;
}

std::string joint_hint(const Reading& reading, const Device& parent, const GeometrySpec& geometry,
                       const std::string& child) {
  const std::vector<std::string> free = offered_joints(reading, parent, geometry.role, child, false);
  if (free.empty()) return "add joint=\"...\" with the name of the joint it moves; no other joint fits";
  std::string others;
  for (std::size_t i = 1; i < free.size(); ++i) others += fmt::format("{}'{}'", i > 1 ? ", " : "", free[i]);
  return fmt::format("add joint=\"{}\"{}", free.front(),
                     others.empty() ? ", the only one that fits and that no device drives"
                                    : ", or another that fits and that no device drives: " + others);
}

bool all_joints_known(const Reading& reading, const std::vector<DeviceId>& children) {
  return std::all_of(children.begin(), children.end(), [&](DeviceId child) {
    return reading.kinematics.joint(reading.robot.devices[child].joint) != nullptr;
  });
}

/// Children that geometry is computed of have to say which joint they drive.
/// @return  all do, and nothing is wrong with these joints
bool check_joints_named(Reading& reading, const Device& parent, const GeometrySpec& geometry,
                        const std::vector<DeviceId>& children) {
  for (const DeviceId child : children) {
    const Device& device = reading.robot.devices[child];
    if (!device.joint.empty() || reading.device_tag(child).attribute("joint") != nullptr) continue;
    at_tag(reading.diagnostics, code::joint_needed, reading.device_tag(child),
           fmt::format("device '{}' has no 'joint'", device.name.text))
        .note(fmt::format("the {} of device '{}' is computed from origin and axis of the joints of its {}",
                          what_is_computed(geometry), parent.name.text, geometry.role))
        .hint(joint_hint(reading, parent, geometry, device.name.text));
  }
  return all_joints_known(reading, children);
}

/// @param link  whose frame; empty: geometry_link()
Placement placement_of(const Reading& reading, const Mechanism& mechanism, const Device& parent,
                       const GeometrySpec& geometry, const std::vector<DeviceId>& children,
                       const std::string& link = {}) {
  std::vector<std::string> joints;
  for (const DeviceId child : children) joints.push_back(reading.robot.devices[child].joint);
  std::string behind;
  for (const DeviceId child : children_in(reading, parent, geometry.behind)) {
    const std::string& joint = reading.robot.devices[child].joint;
    if (reading.kinematics.joint(joint) != nullptr) behind = joint;
  }
  return place(mechanism, geometry, link.empty() ? geometry_link(mechanism, parent.link, geometry, joints) : link,
               joints, behind, geometry_param(parent.params, geometry));
}

/// Directions are asked of it: another link may have axes that fit.
bool has_directions(const GeometrySpec& geometry) { return geometry.kind == "rolling" || !geometry.along.empty(); }

bool all_fit_about(const Reading& reading, const Mechanism& mechanism, const Device& parent, const std::string& link) {
  for (const GeometrySpec& geometry : parent.type->geometry) {
    const std::vector<DeviceId> children = children_in(reading, parent, geometry.role);
    if (!has_directions(geometry) || children.empty()) continue;
    const Placement placement = placement_of(reading, mechanism, parent, geometry, children, link);
    const auto problems = joint_problems(placement);
    const bool fits =
        std::all_of(problems.begin(), problems.end(), [](const auto& problem) { return problem.empty(); });
    if (!fits || !body_problem(mechanism, link, placement.joints).empty()) return false;
  }
  return true;
}

/// Of the links that carry the joints, nearest first, one about whose axes all joints of the device fit; empty: none.
std::string fitting_link(const Reading& reading, const Device& parent, const Placement& placement) {
  if (!has_directions(placement.geometry)) return {};
  const auto all_named = [&](const GeometrySpec& geometry) {
    return all_joints_known(reading, children_in(reading, parent, geometry.role));
  };
  const auto& all = parent.type->geometry;
  if (!std::all_of(all.begin(), all.end(), all_named)) return {};
  for (std::string link = carrier(placement.mechanism, placement.joints); !link.empty();) {
    if (all_fit_about(reading, placement.mechanism, parent, link)) return link;
    const Joint* above = placement.mechanism.joint_to(link);
    link = above == nullptr ? std::string() : above->parent_link;
  }
  return {};
}

/// @return  a link that the numbers may be about
bool check_body(Reading& reading, DeviceId index, const Placement& placement) {
  if (!is_about_body(placement.geometry)) return true;
  const std::string problem = body_problem(placement.mechanism, placement.link, placement.joints);
  if (problem.empty()) return true;
  const Device& device = reading.robot.devices[index];
  const xml::Node& tag = reading.device_tag(index);
  const xml::Attribute* link = tag.attribute("link");
  const std::string message = fmt::format("the {} of device '{}' cannot be about link '{}'",
                                          what_is_computed(placement.geometry), device.name.text, placement.link);
  Diagnostic& finding = link != nullptr ? at_value(reading.diagnostics, code::body_link, *link, message)
                                        : at_tag(reading.diagnostics, code::body_link, tag, message);
  finding.note(problem);
  if (link == nullptr)
    finding.note(fmt::format("it is the link that carries the joints of the {}", placement.geometry.role));
  finding.hint("write link=\"...\" with the name of the robot's body");
  return false;
}

/// Said where an axis is judged that nobody wrote.
void note_default_axis(const Reading& reading, const std::string& joint, Diagnostic& finding) {
  if (reading.kinematics.default_axes.count(joint) > 0)
    finding.note(fmt::format("joint '{}' has no <axis>, so its axis is 1 0 0, the default of URDF", joint));
}

/// All that the numbers are computed of was read without a mistake.
bool is_known(const Reading& reading, const Placement& placement) {
  const bool has_weight = placement.geometry.kind == "chain";
  if (has_weight && !reading.kinematics.wrong_links.empty()) return false;
  return is_place_known(reading, placement.mechanism, placement.link) &&
         std::all_of(placement.joints.begin(), placement.joints.end(), [&](const std::string& joint) {
           return is_place_known(reading, placement.mechanism, placement.mechanism.joint(joint)->child_link);
         });
}

void report_unfit(Reading& reading, const Device& parent, const Placement& placement, DeviceId child,
                  const std::string& problem) {
  const Device& device = reading.robot.devices[child];
  Diagnostic& finding = at_value(reading.diagnostics, code::joint_unfit, *reading.device_tag(child).attribute("joint"),
                                 fmt::format("joint '{}' cannot be {} {} of device '{}'", device.joint,
                                             parent.type->roles[*device.role].max == 1 ? "the" : "one of the",
                                             placement.geometry.role, parent.name.text));
  finding.note(problem);
  note_default_axis(reading, device.joint, finding);
  if (is_about_body(placement.geometry)) finding.note(fmt::format("x, y and z are those of link '{}'", placement.link));
  finding.note("the joint is declared here", reading.kinematics.joint(device.joint)->at);
  if (placement.geometry.kind == "chain") finding.hint("declare turning joints, base to tip");
  const std::string link = fitting_link(reading, parent, placement);
  if (!link.empty())
    finding.hint(
        fmt::format("write link=\"{}\" in the tag of device '{}' if that link's x points ahead, y left and z up", link,
                    parent.name.text));
}

void check_joints_fit(Reading& reading, DeviceId index, const Placement& placement,
                      const std::vector<DeviceId>& children) {
  const Device& parent = reading.robot.devices[index];
  bool all = true;
  const std::vector<std::string> problems = joint_problems(placement);
  for (std::size_t i = 0; i < children.size(); ++i) {
    const bool is_wrong = reading.devices[children[i]].joint_is_wrong;  // which was reported
    const std::string problem = is_wrong ? std::string() : problems[i];
    all = all && !is_wrong && problem.empty();
    if (!problem.empty()) report_unfit(reading, parent, placement, children[i], problem);
  }
  const std::string problem = all ? joints_problem(placement) : std::string();
  if (problem.empty()) return;
  Diagnostic& finding = at_tag(reading.diagnostics, code::joint_unfit, reading.device_tag(index),
                               fmt::format("the joints of the {} of device '{}' do not fit together",
                                           placement.geometry.role, parent.name.text));
  finding.note(problem);
  for (const std::string& joint : placement.joints) note_default_axis(reading, joint, finding);
}

/// The limits of a role's joints against the params that say how far the device turns them.
void check_ranges(Reading& reading, DeviceId index, const Placement& placement, const std::vector<DeviceId>& children) {
  const Device& parent = reading.robot.devices[index];
  const GeometrySpec& geometry = placement.geometry;
  const Range allowed = allowed_range(parent.params, geometry);
  for (std::size_t i = 0; i < children.size(); ++i) {
    const auto limits = limits_along(placement.mechanism, parent.link, geometry, placement.joints[i]);
    if (!limits || reading.devices[children[i]].joint_is_wrong) continue;
    if (limits->lower >= limits->upper) {
      report_no_position(reading, children[i]);
    } else if (const Range range = common(*limits, allowed); range.lower > range.upper) {
      const Joint& joint = *placement.mechanism.joint(placement.joints[i]);
      at_value(
          reading.diagnostics, code::joint_limits, *reading.device_tag(children[i]).attribute("joint"),
          fmt::format("device '{}' reaches no angle within the limits of joint '{}'", parent.name.text, joint.name))
          .note(fmt::format("about {}, the joint turns from {:g} to {:g} rad; '{}' and '{}' allow {:g} to {:g} rad",
                            geometry.along, limits->lower, limits->upper, geometry.lowest, geometry.highest,
                            allowed.lower, allowed.upper))
          .note("the joint is declared here", joint.at)
          .hint(fmt::format("set '{}' and '{}' to angles that the joint reaches, or correct its limits",
                            geometry.lowest, geometry.highest));
    }
  }
}

/// An entry before this one speaks of the role, and has reported what is wrong with its joints.
bool is_checked_before(const DeviceType& type, const GeometrySpec& geometry) {
  return std::any_of(type.geometry.data(), &geometry,
                     [&](const GeometrySpec& before) { return before.role == geometry.role; });
}

}  // namespace

void check_geometry(Reading& reading, DeviceId index) {
  const Device& parent = reading.robot.devices[index];
  if (parent.type == nullptr) return;
  const Mechanism mechanism(reading.kinematics.links, reading.kinematics.joints);
  for (const GeometrySpec& geometry : parent.type->geometry) {
    if (geometry.role.empty()) continue;
    const std::vector<DeviceId> children = children_in(reading, parent, geometry.role);
    const bool none = std::all_of(children.begin(), children.end(), [&](DeviceId child) {
      return reading.device_tag(child).attribute("joint") == nullptr;
    });
    if (children.empty() || (geometry.optional && none)) continue;
    const bool repeats = geometry.kind == "range" && is_checked_before(*parent.type, geometry);
    if (repeats ? !all_joints_known(reading, children) : !check_joints_named(reading, parent, geometry, children))
      continue;
    const Placement placement = placement_of(reading, mechanism, parent, geometry, children);
    const bool has_link = reading.kinematics.link(placement.link) != nullptr;  // else reported
    if (!has_link || !is_known(reading, placement) || !check_body(reading, index, placement)) continue;
    if (!repeats) check_joints_fit(reading, index, placement, children);
    if (geometry.kind == "range") check_ranges(reading, index, placement, children);
  }
}

}  // namespace finemote::gen
