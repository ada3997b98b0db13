#include "generator/geometry/angle.hpp"

#include <fmt/format.h>

#include <cmath>

namespace finemote::gen {

double angle_off(const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
  return std::atan2(one.cross(other).norm(), std::fabs(one.dot(other)));
}

std::string degrees_text(double angle) {
  const std::string text = fmt::format("{:.3g}", angle * 180 / M_PI);
  return text + (text == "1" ? " degree" : " degrees");
}

double radians(double degrees) { return degrees * M_PI / 180; }

}  // namespace finemote::gen
