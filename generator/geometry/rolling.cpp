#include "generator/geometry/rolling.hpp"

#include <cmath>

#include "generator/geometry/allocation.hpp"

namespace finemote::gen {
namespace {

constexpr double kLevel = 0.1;          // z of an axis that counts as level: 6 degrees
constexpr double kBesideMiddle = 1e-3;  // m

}  // namespace

std::string wheel_problem(const Axis& wheel) {
  if (std::fabs(wheel.direction.z()) > kLevel) return "the axis of a wheel lies level";
  if (std::fabs(wheel.direction.y()) < 0.5) return "a wheel of a mecanum base rolls forward, so its axis lies across";
  if (std::fabs(wheel.point.x()) < kBesideMiddle || std::fabs(wheel.point.y()) < kBesideMiddle)
    return "a wheel stands before or behind the middle of the base, and left or right of it: its rollers follow from "
           "that";
  return {};
}

Rolling rolling(const std::vector<Axis>& wheels) {
  Rolling result{Eigen::MatrixX3d(wheels.size(), 3), {}};
  for (std::size_t n = 0; n < wheels.size(); ++n) {
    const Eigen::Vector3d& p = wheels[n].point;
    const Eigen::Vector3d way = wheels[n].direction.cross(Eigen::Vector3d::UnitZ());
    const Eigen::Vector3d roller(1, p.x() * p.y() > 0 ? -1 : 1, 0);
    const Eigen::Vector3d row(roller.x(), roller.y(), roller.y() * p.x() - roller.x() * p.y());
    result.rows.row(static_cast<Eigen::Index>(n)) = row / roller.dot(way);
  }
  result.columns = pseudo_inverse(result.rows);
  return result;
}

}  // namespace finemote::gen
