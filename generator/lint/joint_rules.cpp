#include "generator/lint/joint_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/geometry/angle.hpp"
#include "generator/geometry/chain.hpp"
#include "generator/geometry/frame.hpp"
#include "generator/geometry/range.hpp"
#include "generator/lint/moved_joint.hpp"

namespace finemote::gen {
namespace {

void check_hangs_on_body(const CheckedGeometry& checked, const std::string& name, Findings& findings) {
  const auto moved = moved_between(checked, checked.joint(name).parent_link, checked.link);
  if (!moved) return;
  findings
      .add(checked.child_of(name),
           fmt::format("joint '{}' moves joint '{}', one of the {} of device '{}'", moved->joint->name, name,
                       checked.geometry.role, checked.device.name.text))
      .note(fmt::format("device '{}' drives it", moved->mover->name.text), moved->mover->at)
      .note(fmt::format("the constants of device '{}' are those with that joint at zero", checked.device.name.text))
      .hint("hang it on the body, or see to it that the joint stays at zero while the device drives");
}

void check_follows(const CheckedGeometry& checked, const std::string& before, const std::string& name,
                   Findings& findings) {
  const auto moved = moved_between(checked, checked.joint(name).parent_link, checked.joint(before).child_link);
  if (!moved) return;
  findings
      .add(checked.device,
           fmt::format("joint '{}' lies between joints '{}' and '{}', and is none of the {} of device "
                       "'{}'",
                       moved->joint->name, before, name, checked.geometry.role, checked.device.name.text))
      .note(fmt::format("device '{}' drives it", moved->mover->name.text), moved->mover->at)
      .note("the weight is computed with that joint at zero")
      .hint(fmt::format("make what drives it one of the {}, in its place", checked.geometry.role));
}

void report_param(const CheckedGeometry& checked, const std::string& param, const std::string& joint,
                  const Range& limits, double value, Findings& findings) {
  const auto& params = checked.device.params;
  const bool is_given = std::any_of(params.begin(), params.end(),
                                    [&](const Param& entry) { return entry.spec->name == param && entry.given; });
  if (!is_given) return;
  findings
      .add(checked.device, fmt::format("param '{}' of device '{}' is beyond the limits of joint '{}'", param,
                                       checked.device.name.text, joint))
      .note(fmt::format("it is {:g} rad; about {}, the joint turns from {:g} to {:g} rad, and no further", value,
                        checked.geometry.along, limits.lower, limits.upper))
      .note("the joint is declared here", checked.joint(joint).at)
      .hint(fmt::format("write <param name=\"{}\">{:g}rad</param>, or correct the limits of the joint", param,
                        param == checked.geometry.lowest ? limits.lower : limits.upper));
}

}  // namespace

void find_short_travel(const CheckedGeometry& checked, Findings& findings) {
  const Device& device = checked.device;
  const GeometrySpec& geometry = checked.geometry;
  if (geometry.kind != "range" || !geometry.role.empty()) return;
  const Joint* joint = checked.mechanism.joint(device.joint);
  const auto limits = joint == nullptr ? std::nullopt : limits_of(*joint);
  if (!limits) return;
  const double travel = geometry_param(device.params, geometry), tolerance = radians(geometry.tolerance_deg);
  const Range reached = within_travel(*limits, travel);
  if (reached.lower <= limits->lower + tolerance && reached.upper >= limits->upper - tolerance) return;
  findings
      .add(device, fmt::format("device '{}' does not reach the limits of joint '{}'", device.name.text, joint->name))
      .note(fmt::format("the joint turns from {:g} to {:g} rad, the device from {:.4g} to {:.4g} rad", limits->lower,
                        limits->upper, -travel / 2, travel / 2))
      .note("the joint is declared here", joint->at)
      .hint(fmt::format("set '{}' to what the part can do, or narrow the joint's limits", geometry.param));
}

void find_limited_wheels(const CheckedGeometry& checked, Findings& findings) {
  if (!is_about_body(checked.geometry)) return;
  for (const std::string& name : checked.joints) {
    const Joint& joint = checked.joint(name);
    const auto limits = limits_of(joint);
    if (!limits || limits->upper - limits->lower >= 2 * M_PI) continue;
    findings
        .add(checked.child_of(name), fmt::format("joint '{}', one of the {} of device '{}', cannot turn round", name,
                                                 checked.geometry.role, checked.device.name.text))
        .note(fmt::format("it is revolute, from {:g} to {:g} rad", limits->lower, limits->upper))
        .note("the joint is declared here", joint.at)
        .hint("write type=\"continuous\" in the tag of the joint");
  }
}

void find_moved_joints(const CheckedGeometry& checked, Findings& findings) {
  const auto& joints = checked.joints;
  if (is_about_body(checked.geometry)) {
    for (const std::string& name : joints) check_hangs_on_body(checked, name, findings);
  }
  if (checked.geometry.kind == "chain") {
    for (std::size_t n = 1; n < joints.size(); ++n) check_follows(checked, joints[n - 1], joints[n], findings);
  }
}

void find_massless_chain(const CheckedGeometry& checked, Findings& findings) {
  const Device& device = checked.device;
  const GeometrySpec& geometry = checked.geometry;
  if (geometry.kind != "chain" || checked.joints.empty()) return;
  const auto links = chain(checked.mechanism, checked.joints, checked.link);
  const bool has_mass = std::any_of(links.begin(), links.end(), [](const ChainLink& link) { return link.mass > 0; });
  const bool carries = geometry.param.empty() || geometry_param(device.params, geometry) != 0;
  if (has_mass || !carries) return;
  Diagnostic& finding = findings.add(
      device, fmt::format("nothing that the {} of device '{}' move has a mass", geometry.role, device.name.text));
  finding.note("the weight it carries is computed from the <inertial> of the links, and is 0")
      .hint("add an <inertial> with the mass of each link");
  if (!geometry.param.empty())
    finding.hint(fmt::format("if the weight is balanced, add <param name=\"{}\">0</param>", geometry.param));
}

void find_wide_params(const CheckedGeometry& checked, Findings& findings) {
  const GeometrySpec& geometry = checked.geometry;
  if (geometry.kind != "range") return;
  const Range allowed = allowed_range(checked.device.params, geometry);
  const double tolerance = radians(geometry.tolerance_deg);
  for (const std::string& name : checked.joints) {
    const auto limits = limits_along(checked.mechanism, checked.device.link, geometry, name);
    if (!limits) continue;
    if (allowed.lower < limits->lower - tolerance)
      report_param(checked, geometry.lowest, name, *limits, allowed.lower, findings);
    if (allowed.upper > limits->upper + tolerance)
      report_param(checked, geometry.highest, name, *limits, allowed.upper, findings);
  }
}

}  // namespace finemote::gen
