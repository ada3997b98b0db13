#include "generator/geometry/cause.hpp"

#include <algorithm>
#include <cmath>

#include "generator/geometry/angle.hpp"

namespace finemote::gen {
namespace {

bool is_produced(const std::vector<Axis>& actuators, std::size_t axis, double tolerance) {
  return axis_yields(actuators).at(axis).fraction >= std::cos(tolerance) * std::cos(tolerance);
}

double coordinate_of(const Axis& actuator, Eigen::Index k) { return actuator.point[k]; }

/// Values no further than `gap` from the next one, made equal. @return  the widest group
double made_equal(std::vector<Axis>& actuators, Eigen::Index k, double gap) {
  std::vector<Axis*> sorted;
  for (Axis& actuator : actuators) sorted.push_back(&actuator);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const Axis* a, const Axis* b) { return coordinate_of(*a, k) < coordinate_of(*b, k); });
  double widest = 0;
  for (std::size_t first = 0, end = 0; first < sorted.size(); first = end) {
    const auto value = [&](std::size_t n) { return coordinate_of(*sorted[n], k); };
    for (end = first + 1; end < sorted.size() && value(end) - value(end - 1) <= gap; ++end) continue;
    widest = std::max(widest, value(end - 1) - value(first));
    const double middle = (value(first) + value(end - 1)) / 2;
    for (std::size_t n = first; n < end; ++n) sorted[n]->point[k] = middle;
  }
  return widest;
}

}  // namespace

bool comes_from_axes(const std::vector<Axis>& actuators, std::size_t axis, double tolerance) {
  std::vector<Axis> parallel = actuators;
  for (std::size_t n = 0; n < parallel.size(); ++n) {
    for (std::size_t before = 0; before < n; ++before) {
      const Eigen::Vector3d& other = parallel[before].direction;
      if (angle_off(parallel[n].direction, other) > tolerance) continue;
      parallel[n].direction = other.dot(parallel[n].direction) < 0 ? Eigen::Vector3d(-other) : other;
      break;
    }
  }
  return !is_produced(parallel, axis, tolerance);
}

NearOrigins near_origins(const std::vector<Axis>& actuators, std::size_t axis, double tolerance) {
  Eigen::AlignedBox3d box;
  for (const Axis& actuator : actuators) box.extend(actuator.point);
  const double gap = box.diagonal().norm() * std::tan(tolerance);
  for (Eigen::Index k = 0; k < 3; ++k) {
    std::vector<Axis> in_line = actuators;
    const double apart = made_equal(in_line, k, gap);
    if (!is_produced(in_line, axis, tolerance)) return {static_cast<char>('x' + k), apart};
  }
  return {};
}

}  // namespace finemote::gen
