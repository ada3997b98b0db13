#include "generator/geometry/rolling.hpp"

#include <fmt/format.h>

#include <cmath>

#include "generator/geometry/allocation.hpp"
#include "generator/geometry/angle.hpp"

namespace finemote::gen {
namespace {

constexpr double kBesideMiddle = 1e-3;  // m
constexpr double kLeastShare = 1e-3;    // of the strongest motion the wheels make: less is none

Eigen::MatrixX3d wheel_rows(const std::vector<Axis>& wheels) {
  Eigen::MatrixX3d rows(wheels.size(), 3);
  for (std::size_t n = 0; n < wheels.size(); ++n) {
    const Eigen::Vector3d& p = wheels[n].point;
    const Eigen::Vector3d way = wheels[n].direction.cross(Eigen::Vector3d::UnitZ());
    const Eigen::Vector3d roller(1, p.x() * p.y() > 0 ? -1 : 1, 0);
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
  if (std::fabs(wheel.point.x()) < kBesideMiddle || std::fabs(wheel.point.y()) < kBesideMiddle)
    return "a wheel lies ahead of or behind the middle of the base, and left or right of it: its rollers follow from "
           "that";
  return {};
}

bool leave_a_motion_free(const std::vector<Axis>& wheels) {
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
