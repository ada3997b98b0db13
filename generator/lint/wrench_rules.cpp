#include "generator/lint/wrench_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/geometry/allocation.hpp"
#include "generator/geometry/angle.hpp"
#include "generator/geometry/cause.hpp"

namespace finemote::gen {
namespace {

constexpr double kOnePlace = 1e-3;  // m

double tolerance_of(const CheckedGeometry& checked) { return radians(checked.geometry.tolerance_deg); }

std::vector<Axis> axes_of(const CheckedGeometry& checked) {
  std::vector<Axis> axes;
  for (const std::string& joint : checked.joints)
    axes.push_back(joint_axis(checked.mechanism, joint, checked.link).value());
  return axes;
}

/// An axis of the wrench that the device commands, and how the actuators produce it.
struct Yield {
  std::size_t axis;
  AxisYield yield;

  [[nodiscard]] const char* name() const { return kWrenchAxes[axis]; }
};

/// None for what allocates nothing.
std::vector<Yield> commanded_yields(const CheckedGeometry& checked) {
  if (checked.geometry.kind != "allocation" || checked.joints.empty()) return {};
  const auto& commands = checked.geometry.commands;
  const auto yields = axis_yields(axes_of(checked));
  std::vector<Yield> commanded;
  for (std::size_t axis = 0; axis < yields.size(); ++axis) {
    if (commands.empty() || std::find(commands.begin(), commands.end(), kWrenchAxes[axis]) != commands.end())
      commanded.push_back({axis, yields[axis]});
  }
  return commanded;
}

/// An axis counts as produced where it lies within the tolerance of what the actuators produce.
bool is_produced(const AxisYield& yield, double tolerance) {
  return yield.fraction >= std::cos(tolerance) * std::cos(tolerance);
}

/// 0.999 is not 1: as many digits as tell them apart.
std::string fraction_text(double fraction) {
  if (fraction < 1e-9) return "nothing";
  return fraction > 0.9995 ? fmt::format("only {:.6f}", fraction) : fmt::format("only {:.3g}", fraction);
}

/// What hardly differs: axes, origins, or neither by itself.
void say_cause(const CheckedGeometry& checked, std::size_t axis, Diagnostic& finding) {
  const std::vector<Axis> axes = axes_of(checked);
  const double tolerance = tolerance_of(checked);
  if (comes_from_axes(axes, axis, tolerance)) {
    finding.note(fmt::format("it comes from axes that are less than {} apart", degrees_text(tolerance)))
        .hint("write axes that are meant to be parallel exactly so");
  } else if (const NearOrigins near = near_origins(axes, axis, tolerance); near.coordinate != 0) {
    finding
        .note(fmt::format("it comes from origins that are only {:.3g} mm apart along {} of link '{}'",
                          near.apart * 1000, near.coordinate, checked.link))
        .hint("write origins that are meant to be in line exactly so, or move them further apart");
  } else {
    finding.note("it comes from small differences of origins and axes together")
        .hint("check the origins and axes of their joints");
  }
}

void check_place(const CheckedGeometry& checked, const std::string& before, const std::string& name,
                 Findings& findings) {
  const auto first = joint_axis(checked.mechanism, before, checked.link);
  const auto second = joint_axis(checked.mechanism, name, checked.link);
  const bool is_same = (first->point - second->point).norm() < kOnePlace &&
                       angle_off(first->direction, second->direction) <= tolerance_of(checked);
  if (!is_same) return;
  findings
      .add(checked.child_of(name),
           fmt::format("joints '{}' and '{}' are in the same place and on the same axis", before, name))
      .note(fmt::format("for the allocation of device '{}' they are one of its {}, counted twice",
                        checked.device.name.text, checked.geometry.role))
      .note("the first is declared here", checked.joint(before).at)
      .note("the second is declared here", checked.joint(name).at)
      .hint("correct one of the origins; for two rotors on one shaft allow FM3167");
}

}  // namespace

void find_missing_axes(const CheckedGeometry& checked, Findings& findings) {
  for (const Yield& commanded : commanded_yields(checked)) {
    if (is_produced(commanded.yield, tolerance_of(checked))) continue;
    findings
        .add(checked.device,
             fmt::format("the {} of device '{}' yield {} of a unit command on '{}'", checked.geometry.role,
                         checked.device.name.text, fraction_text(commanded.yield.fraction), commanded.name()))
        .note(fmt::format("the wrench is in the axes of link '{}' and about its origin", checked.link))
        .hint(
            "check the origins and axes of their joints, name the body with link=\"...\", or list the axes it "
            "commands under 'commands' in the descriptor's geometry");
  }
}

void find_weak_axes(const CheckedGeometry& checked, Findings& findings) {
  const double tolerance = tolerance_of(checked);
  for (const Yield& commanded : commanded_yields(checked)) {
    // Hardly produced: only by the little in which actuators lie within the tolerance of not producing it.
    const bool is_weak = is_produced(commanded.yield, tolerance) && commanded.yield.effort > 1 / std::sin(tolerance);
    if (!is_weak) continue;
    Diagnostic& finding =
        findings.add(checked.device, fmt::format("the {} of device '{}' hardly produce '{}': one of them pushes {:.3g} "
                                                 "times as hard",
                                                 checked.geometry.role, checked.device.name.text, commanded.name(),
                                                 commanded.yield.effort));
    say_cause(checked, commanded.axis, finding);
  }
}

void find_doubled_axes(const CheckedGeometry& checked, Findings& findings) {
  if (checked.geometry.kind != "allocation") return;
  const auto& joints = checked.joints;
  for (std::size_t n = 0; n < joints.size(); ++n) {
    for (std::size_t before = 0; before < n; ++before) check_place(checked, joints[before], joints[n], findings);
  }
}

}  // namespace finemote::gen
