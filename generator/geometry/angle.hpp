// Directions to the angle between them, and to words.
#pragma once

#include <Eigen/Geometry>
#include <string>

namespace finemote::gen {

/// Between two lines of unit length, whichever way they point [rad, 0 to pi/2].
double angle_off(const Eigen::Vector3d& one, const Eigen::Vector3d& other);

/// `1.5 degrees`; one decimal, of small angles as many as they need.
std::string degrees_text(double angle);

/// @param degrees  of a descriptor
double radians(double degrees);

}  // namespace finemote::gen
