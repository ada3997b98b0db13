#include "generator/lint/mechanics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/geometry/allocation.hpp"
#include "generator/geometry/angle.hpp"
#include "generator/geometry/cause.hpp"
#include "generator/geometry/frame.hpp"
#include "generator/geometry/range.hpp"
#include "generator/geometry/role_joints.hpp"
#include "generator/lint/codes.hpp"

namespace finemote::gen {
namespace {

Diagnostic finding(LintCode code, const Device& device, std::string message) {
  Diagnostic result{Severity::warning, code.code, device.at, 7, std::move(message), {}, {}};
  return result;
}

bool commands(const GeometrySpec& geometry, const std::string& axis) {
  const auto& list = geometry.commands;
  return list.empty() || std::find(list.begin(), list.end(), axis) != list.end();
}

/// 0.999 is not 1: as many digits as tell them apart.
std::string fraction_text(double fraction) {
  if (fraction < 1e-9) return "nothing";
  return fraction > 0.9995 ? fmt::format("only {:.6f}", fraction) : fmt::format("only {:.3g}", fraction);
}

/// What hardly differs: axes, origins, or neither by itself.
void say_cause(const std::vector<Axis>& axes, std::size_t axis, double tolerance, const std::string& link,
               Diagnostic& finding) {
  if (comes_from_axes(axes, axis, tolerance)) {
    finding.note(fmt::format("it comes from axes that are less than {} apart", degrees_text(tolerance)))
        .hint("write axes that are meant to be parallel exactly so");
  } else if (const NearOrigins near = near_origins(axes, axis, tolerance); near.coordinate != 0) {
    finding
        .note(fmt::format("it comes from origins that are only {:.3g} mm apart along {} of link '{}'",
                          near.apart * 1000, near.coordinate, link))
        .hint("write origins that are meant to be in line exactly so, or move them further apart");
  } else {
    finding.note("it comes from small differences of origins and axes together")
        .hint("check the origins and axes of their joints");
  }
}

/// An axis counts as produced where it lies within the tolerance of what the actuators produce, and as hardly produced
/// where only what lies within the tolerance of not producing it does.
void check_axis(const Device& device, const GeometrySpec& geometry, const std::string& link,
                const std::vector<Axis>& axes, std::size_t axis, const AxisYield& yield,
                std::vector<Diagnostic>& findings) {
  const double tolerance = radians(geometry.tolerance_deg);
  if (yield.fraction < std::cos(tolerance) * std::cos(tolerance)) {
    findings.push_back(
        finding(code::lint_wrench_axis, device,
                fmt::format("the {} of device '{}' yield {} of a unit command on '{}'", geometry.role, device.name.text,
                            fraction_text(yield.fraction), kWrenchAxes[axis]))
            .note(fmt::format("the wrench is in the axes of link '{}' and about its origin", link))
            .hint("check the origins and axes of their joints, name the body with link=\"...\", or list the axes it "
                  "commands under 'commands' in the descriptor's geometry"));
  } else if (yield.effort > 1 / std::sin(tolerance)) {
    findings.push_back(
        finding(code::lint_wrench_effort, device,
                fmt::format("the {} of device '{}' hardly produce '{}': one of them pushes {:.3g} times as hard",
                            geometry.role, device.name.text, kWrenchAxes[axis], yield.effort)));
    say_cause(axes, axis, tolerance, link, findings.back());
  }
}

void check_allocation(const Robot& robot, const Device& device, const GeometrySpec& geometry,
                      std::vector<Diagnostic>& findings) {
  const Mechanism mechanism(robot);
  const std::vector<std::string> joints = role_joints(robot, device, geometry);
  if (joints.empty()) return;
  const std::string link = geometry_link(mechanism, device, geometry, joints);
  std::vector<Axis> axes;
  for (const std::string& joint : joints) axes.push_back(joint_axis(mechanism, joint, link).value());
  const auto yields = axis_yields(axes);
  for (std::size_t axis = 0; axis < yields.size(); ++axis) {
    if (commands(geometry, kWrenchAxes[axis])) check_axis(device, geometry, link, axes, axis, yields[axis], findings);
  }
}

void check_range(const Robot& robot, const Device& device, const GeometrySpec& geometry,
                 std::vector<Diagnostic>& findings) {
  const Joint* joint = Mechanism(robot).joint(device.joint);
  const auto limits = joint == nullptr ? std::nullopt : limits_of(*joint);
  if (!limits) return;
  const double travel = geometry_param(device, geometry), tolerance = radians(geometry.tolerance_deg);
  const Range reached = within_travel(*limits, travel);
  if (reached.lower <= limits->lower + tolerance && reached.upper >= limits->upper - tolerance) return;
  findings.push_back(
      finding(code::lint_out_of_reach, device,
              fmt::format("device '{}' does not reach the limits of joint '{}'", device.name.text, joint->name))
          .note(fmt::format("the joint turns from {:g} to {:g} rad, the device from {:.4g} to {:.4g} rad",
                            limits->lower, limits->upper, -travel / 2, travel / 2))
          .note("the joint is declared here", joint->at)
          .hint(fmt::format("set '{}' to what the part can do, or narrow the joint's limits", geometry.param)));
}

}  // namespace

std::vector<Diagnostic> mechanics_findings(const Robot& robot, const Device& device) {
  std::vector<Diagnostic> findings;
  for (const GeometrySpec& geometry : device.type->geometry) {
    if (geometry.kind == "allocation") check_allocation(robot, device, geometry, findings);
    if (geometry.kind == "range" && geometry.role.empty()) check_range(robot, device, geometry, findings);
  }
  return findings;
}

}  // namespace finemote::gen
