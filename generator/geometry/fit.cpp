#include "generator/geometry/fit.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/geometry/angle.hpp"
#include "generator/geometry/chain.hpp"
#include "generator/geometry/rolling.hpp"

namespace finemote::gen {
namespace {

constexpr double kOnePlace = 1e-3;  // m, between wheels whose radius is not known

std::vector<Axis> axes_of(const Placement& placement) {
  std::vector<Axis> axes;
  for (const std::string& joint : placement.joints) {
    if (const auto axis = joint_axis(placement.mechanism, joint, placement.link)) axes.push_back(*axis);
  }
  return axes;
}

double tolerance(const Placement& placement) { return radians(placement.geometry.tolerance_deg); }

std::string direction_problem(const Placement& placement, const Eigen::Vector3d& direction) {
  const std::string& along = placement.geometry.along;
  if (along.empty()) return {};
  const double off = angle_off(direction, Eigen::Vector3d::Unit(along[0] - 'x'));
  if (off <= tolerance(placement)) return {};
  return fmt::format("its axis points {} away from the {} axis of link '{}'; the {} turns about {}, within {}",
                     degrees_text(off), along, placement.link, placement.geometry.role, along,
                     degrees_text(tolerance(placement)));
}

std::string order_problem(const Placement& placement, const Joint& joint) {
  if (placement.behind.empty()) return {};
  const auto way = placement.mechanism.way_to(joint.parent_link);
  const bool follows =
      way && std::any_of(way->begin(), way->end(), [&](const Joint* step) { return step->name == placement.behind; });
  return follows ? std::string()
                 : fmt::format("it does not hang behind joint '{}', which turns the {}", placement.behind,
                               placement.geometry.behind);
}

/// Where another wheel stands in its place.
std::string place_problem(const Placement& placement, std::size_t index, const Axis& wheel) {
  const double radius = placement.radius > 0 ? placement.radius : kOnePlace;
  for (std::size_t before = 0; before < index; ++before) {
    const auto other = joint_axis(placement.mechanism, placement.joints[before], placement.link);
    if (other && (wheel.point - other->point).norm() < radius)
      return fmt::format("it is in the same place as the wheel of joint '{}'", placement.joints[before]);
  }
  return {};
}

std::string wheel_problem(const Placement& placement, std::size_t index, const Axis& wheel) {
  std::string problem = wheel_problem(wheel, tolerance(placement));
  if (problem.empty()) problem = place_problem(placement, index, wheel);
  const std::vector<Axis> wheels = axes_of(placement);
  if (problem.empty() && wheels.size() == placement.joints.size()) problem = corner_problem(wheels, index);
  return problem;
}

}  // namespace

bool turns(const Joint& joint) { return joint.type == "revolute" || joint.type == "continuous"; }

std::string joint_problem(const Placement& placement, std::size_t index) {
  const std::string& name = placement.joints[index];
  const Joint& joint = *placement.mechanism.joint(name);
  const auto axis = joint_axis(placement.mechanism, name, placement.link);
  if (!turns(joint)) return fmt::format("it is {}; a joint that turns is revolute or continuous", joint.type);
  if (!axis) return placement.mechanism.way_to(joint.child_link) ? "its axis has no direction" : "";
  if (placement.geometry.kind == "rolling") return wheel_problem(placement, index, *axis);
  if (placement.geometry.kind == "chain") return chain_problem(placement.mechanism, placement.joints, index);
  if (placement.geometry.kind != "axes") return {};
  const std::string problem = direction_problem(placement, axis->direction);
  return problem.empty() ? order_problem(placement, joint) : problem;
}

std::string joints_problem(const Placement& placement) {
  if (placement.geometry.kind != "rolling" || !leave_a_motion_free(axes_of(placement))) return {};
  return "there is a motion forward, sideways or round that none of these wheels resists";
}

}  // namespace finemote::gen
