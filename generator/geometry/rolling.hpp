// Mecanum wheels to how they roll when the base moves, and how the base moves when they roll.
#pragma once

#include "generator/geometry/mechanism.hpp"

namespace finemote::gen {

/// Rows: a wheel's rolling speed (its angular speed times its radius) [m/s] = row * (forward [m/s], left [m/s], turn
/// [rad/s]); columns: their pseudo-inverse, so that the motion is the sum of column * rolling speed.
struct Rolling {
  Eigen::MatrixX3d rows;
  Eigen::Matrix3Xd columns;
};

/// Why a wheel with this axis cannot be one of a mecanum base; empty: it can.
/// @param tolerance  how far its axis may point away from the base's y axis [rad]
std::string wheel_problem(const Axis& wheel, double tolerance);

/// Why the place of each of these wheels does not say how its rollers point; empty: it does. Front and rear, left and
/// right are seen from the middle between the outermost wheels, wherever the origin is.
std::vector<std::string> corner_problems(const std::vector<Axis>& wheels);

/// Whether wheels, each without wheel_problem() and corner_problems(), leave a motion forward, sideways or round that
/// none of them resists: then the wheels' speeds do not say how the base moves.
bool leave_a_motion_free(const std::vector<Axis>& wheels);

/// Wheels with rollers at 45 degrees, set up as an X seen from above: at the ground, those of the front left wheel hold
/// against motion forward and to the right, as do those of the rear right one, the other two forward and to the left.
/// A wheel turns positive about its joint's axis, wherever that points. With d the way a wheel rolls and s the roller's
/// axis at the ground, the contact does not slide along s: s . (v + w x p) = (s . d) * rolling speed.
/// (K. Lynch, F. Park, Modern Robotics, 13.2.1.)
/// @param wheels  each without wheel_problem() and corner_problems(), and not leave_a_motion_free()
Rolling rolling(const std::vector<Axis>& wheels);

}  // namespace finemote::gen
