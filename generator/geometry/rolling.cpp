#include "generator/geometry/rolling.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "generator/geometry/allocation.hpp"
#include "generator/geometry/angle.hpp"

namespace finemote::gen {
namespace {

constexpr double kBesideMiddle = 1e-3;  // m
constexpr std::size_t kCorners = 4;
constexpr double kLeastShare = 1e-3;  // of the strongest motion the wheels make: less is none

/// Between the outermost wheels: the link's own origin may be anywhere, at a bumper for example.
Eigen::Vector2d middle_of(const std::vector<Axis>& wheels) {
  Eigen::AlignedBox2d box;
  for (const Axis& wheel : wheels) box.extend(wheel.point.head<2>().eval());
  return box.center();
}

/// Of the wheel, seen from the middle: (1, 1) front left, (-1, -1) rear right.
Eigen::Vector2d corner(const Axis& wheel, const Eigen::Vector2d& middle) {
  return (wheel.point.head<2>() - middle).array().sign();
}

/// With one before it.
bool shares_corner(const std::vector<Axis>& wheels, std::size_t index, const Eigen::Vector2d& middle) {
  for (std::size_t before = 0; before < index; ++before) {
    if (corner(wheels[before], middle) == corner(wheels[index], middle)) return true;
  }
  return false;
}

Eigen::MatrixX3d wheel_rows(const std::vector<Axis>& wheels) {
  const Eigen::Vector2d middle = middle_of(wheels);
  Eigen::MatrixX3d rows(wheels.size(), 3);
  for (std::size_t n = 0; n < wheels.size(); ++n) {
    const Eigen::Vector3d& p = wheels[n].point;
    const Eigen::Vector3d way = wheels[n].direction.cross(Eigen::Vector3d::UnitZ());
    const Eigen::Vector3d roller(1, corner(wheels[n], middle).prod() > 0 ? -1 : 1, 0);
    const Eigen::Vector3d row(roller.x(), roller.y(), roller.y() * p.x() - roller.x() * p.y());
    rows.row(static_cast<Eigen::Index>(n)) = row / roller.dot(way);
  }
  return rows;
}

}  // namespace

std::string wheel_problem(const Axis& wheel, double tolerance) {
  const double off = angle_off(wheel.direction, Eigen::Vector3d::UnitY());
  if (off > tolerance)
    return fmt::format("its axis points {} away from the base's y axis; a mecanum wheel rolls forward, within {}",
                       degrees_text(off), degrees_text(tolerance));
  return {};
}

std::vector<std::string> corner_problems(const std::vector<Axis>& wheels) {
  const Eigen::Vector2d middle = middle_of(wheels);
  std::vector<std::string> problems(wheels.size());
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    const bool is_beside = (wheels[i].point.head<2>() - middle).cwiseAbs().minCoeff() < kBesideMiddle;
    if (is_beside)
      problems[i] =
          "a wheel lies ahead of or behind the middle of all wheels, and left or right of it: its rollers follow from "
          "that";
    else if (wheels.size() == kCorners && shares_corner(wheels, i, middle))
      problems[i] = "it is at the same corner of the base as another wheel; four mecanum wheels have one corner each";
  }
  return problems;
}

bool leave_a_motion_free(const std::vector<Axis>& wheels) {
  if (wheels.empty()) return false;  // why there is none was reported
  Eigen::MatrixX3d rows = wheel_rows(wheels);
  double reach = 0;
  for (const Axis& wheel : wheels) reach = std::max(reach, wheel.point.head<2>().norm());
  rows.col(2) /= reach;  // turning at the speed of the outermost wheel
  const Eigen::VectorXd values = singular_values(rows);
  return values.size() < 3 || values[2] < kLeastShare * values[0];
}

Rolling rolling(const std::vector<Axis>& wheels) {
  const Eigen::MatrixX3d rows = wheel_rows(wheels);
  return {rows, pseudo_inverse(rows)};
}

}  // namespace finemote::gen
