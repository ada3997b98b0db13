// What the generator computes of the URDF's links and joints for a device's constructor, besides thruster allocation.
//
// Coordinates are those of a link (x forward, y left, z up) that constants.hpp names, with every joint at zero:
// docs/reference/geometry.md. Geometry kind `axes` gives a Vector of unit length per joint, kind `mount` the Rotation
// from a sensor's axes to those its data are used in.
#pragma once

#include "finemote/control/rotation.hpp"

namespace finemote {

/// A mecanum wheel of a base: geometry kind `rolling`.
struct RollingWheel {
  float forward;     ///< rolling speed [m/s] where the base moves 1 m/s forward
  float left;        ///< rolling speed [m/s] where the base moves 1 m/s to the left
  float turn;        ///< rolling speed [m/s] where the base turns 1 rad/s to the left
  float to_forward;  ///< its share in the base's forward speed [m/s], per m/s of rolling speed
  float to_left;     ///< its share in the base's speed to the left [m/s], per m/s of rolling speed
  float to_turn;     ///< its share in the base's turn to the left [rad/s], per m/s of rolling speed
};

/// A joint of a serial chain, with what moves with it but not with the next: geometry kind `chain`.
struct ChainLink {
  Vector offset;  ///< from the joint before; the first: from that link's origin [m]
  Vector axis;    ///< unit length
  Vector centre;  ///< of the mass, from the joint [m]
  float mass;     ///< [kg]
};

/// How far a joint may turn, within the reach of what drives it: geometry kind `range`.
struct JointRange {
  float lower;  ///< rad; without a limit the lowest float
  float upper;  ///< rad, >= lower; without a limit the largest float
};

/// An angle aimed at, kept within the range. An aim that is outside is not thrown back: it goes no further out.
/// @param range   null: any angle
/// @param aim     the angle wanted [rad]
/// @param before  the last angle aimed at [rad]
constexpr float kept_within(const JointRange* range, float aim, float before) {
  if (range == nullptr) return aim;
  const float low = before < range->lower ? before : range->lower, high = before > range->upper ? before : range->upper;
  return aim < low ? low : aim > high ? high : aim;
}

}  // namespace finemote
