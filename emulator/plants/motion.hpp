// What a sensor feels, and the bodies and joints it gets it from.
#pragma once

#include <Eigen/Geometry>

#include "emulator/time.hpp"

namespace finemote::emulator {

inline constexpr double kGravity = 9.80665;  ///< m/s^2

/// Pose and motion of a rigid body. World: z up; body: x forward, y left, z up.
struct Motion {
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();  ///< body to world
  Eigen::Vector3d position = Eigen::Vector3d::Zero();            ///< of the origin in the world [m]
  Eigen::Vector3d rate = Eigen::Vector3d::Zero();                ///< in the body's axes [rad/s]
  Eigen::Vector3d force = Eigen::Vector3d(0, 0, kGravity);       ///< specific force in the body's axes [m/s^2]
};

/// Roll, pitch, yaw [rad]: fixed axes x, y, z, as URDF has them.
struct Angles {
  double roll = 0, pitch = 0, yaw = 0;
};

inline Angles angles_of(const Eigen::Quaterniond& q) {
  const double sine = 2 * (q.w() * q.y() - q.z() * q.x());
  return Angles{std::atan2(2 * (q.w() * q.x() + q.y() * q.z()), 1 - 2 * (q.x() * q.x() + q.y() * q.y())),
                std::asin(sine < -1  ? -1
                          : sine > 1 ? 1
                                     : sine),
                std::atan2(2 * (q.w() * q.z() + q.x() * q.y()), 1 - 2 * (q.y() * q.y() + q.z() * q.z()))};
}

inline Eigen::Quaterniond attitude_of(const Angles& angles) {
  return Eigen::AngleAxisd(angles.yaw, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(angles.pitch, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(angles.roll, Eigen::Vector3d::UnitX());
}

/// Something that moves.
class Body {
 public:
  virtual ~Body() = default;
  virtual Motion motion(Time now) = 0;
};

/// The output of a motor.
class Shaft {
 public:
  virtual ~Shaft() = default;
  virtual double angle(Time now) = 0;  ///< rad
  virtual double speed(Time now) = 0;  ///< rad/s
};

}  // namespace finemote::emulator
