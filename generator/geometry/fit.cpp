#include "generator/geometry/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "generator/geometry/angle.hpp"
#include "generator/geometry/chain.hpp"
#include "generator/geometry/rolling.hpp"

namespace finemote::gen {
namespace {

constexpr double kOnePlace = 1e-3;  // m, between wheels whose radius is not known

/// None unless all joints have one.
std::vector<Axis> wheels_of(const Placement& placement) {
  std::vector<Axis> wheels;
  for (const auto& axis : placement.axes) {
    if (!axis) return {};
    wheels.push_back(*axis);
  }
  return wheels;
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
    const auto& other = placement.axes[before];
    if (other && (wheel.point - other->point).norm() < radius)
      return fmt::format("it is in the same place as the wheel of joint '{}'", placement.joints[before]);
  }
  return {};
}

std::string joint_problem(const Placement& placement, std::size_t index) {
  const Joint& joint = *placement.mechanism.joint(placement.joints[index]);
  const auto& axis = placement.axes[index];
  if (!turns(joint)) return fmt::format("it is {}; a joint that turns is revolute or continuous", joint.type);
  if (!axis) return placement.mechanism.way_to(joint.child_link) ? "its axis has no direction" : "";
  if (placement.geometry.kind == "rolling") {
    const std::string problem = wheel_problem(*axis, tolerance(placement));
    return problem.empty() ? place_problem(placement, index, *axis) : problem;
  }
  if (placement.geometry.kind == "chain") return chain_problem(placement.mechanism, placement.joints, index);
  if (placement.geometry.kind != "axes") return {};
  const std::string problem = direction_problem(placement, axis->direction);
  return problem.empty() ? order_problem(placement, joint) : problem;
}

}  // namespace

bool turns(const Joint& joint) { return joint.type == "revolute" || joint.type == "continuous"; }

Placement place(const Mechanism& mechanism, const GeometrySpec& geometry, std::string link,
                std::vector<std::string> joints, std::string behind, double radius) {
  std::vector<std::optional<Axis>> axes;
  for (const std::string& joint : joints) axes.push_back(joint_axis(mechanism, joint, link));
  return {mechanism, geometry, std::move(link), std::move(joints), std::move(behind), radius, std::move(axes)};
}

std::vector<std::string> joint_problems(const Placement& placement) {
  std::vector<std::string> problems;
  for (std::size_t i = 0; i < placement.joints.size(); ++i) problems.push_back(joint_problem(placement, i));
  if (placement.geometry.kind != "rolling") return problems;
  const std::vector<std::string> corners = corner_problems(wheels_of(placement));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (problems[i].empty()) problems[i] = corners[i];
  }
  return problems;
}

std::string joints_problem(const Placement& placement) {
  const std::vector<Axis> wheels = placement.geometry.kind == "rolling" ? wheels_of(placement) : std::vector<Axis>{};
  if (wheels.empty() || !leave_a_motion_free(wheels)) return {};
  return "there is a motion forward, sideways or round that none of these wheels resists";
}

}  // namespace finemote::gen
