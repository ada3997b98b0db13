// Turns an operator's sticks into the torques of four mecanum wheels, and the wheels' speeds into the body's motion.
#pragma once

#include "finemote/contract.hpp"
#include "finemote/control/pid.hpp"
#include "finemote/interfaces/motor.hpp"
#include "finemote/interfaces/remote.hpp"

namespace finemote {

/// Wheels in the order front left, front right, rear left, rear right, rollers as an X seen from above; every motor
/// turns positive when its wheel rolls forward. Frame x forward, y left, z up.
///
/// The left stick moves, the right stick's x turns. Drives while the left switch is up or in the middle; with the
/// switch down, or without fresh data of remote and wheels, the commands are invalid and the motors stop by themselves.
/// Each wheel has a speed loop in real units. What the motors get is as old as the oldest input.
class MecanumChassis {
 public:
  static constexpr unsigned kWheels = 4;

  struct Config {
    float wheel_radius = 0.076F;  ///< m
    float reach = 0.4F;           ///< m, half wheelbase plus half track
    float max_speed = 2;          ///< m/s, at a full stick
    float max_turn = 4;           ///< rad/s
    float kp = 0.1F;              ///< N m per rad/s of wheel speed
    float ki = 0.5F;              ///< N m per rad
    float max_torque = 3;         ///< N m per wheel
    Duration max_age = 100 * kMillisecond;
  };

  constexpr MecanumChassis(const Config& config, Ports<Motor> wheels, Port<Remote> remote)
      : config_(config), wheels_(wheels), remote_(remote) {}

  void update();
  void handle();

  Stamp state;  ///< as old as the oldest input, valid while all are

  /// Motion of the body from the wheels: m/s forward, m/s to the left, rad/s.
  struct Motion {
    float forward = 0, left = 0, turn = 0;
  };
  [[nodiscard]] const Motion& motion() const { return motion_; }

  /// Wheel speeds [rad/s] for a motion, in the order of the wheels.
  static void wheel_speeds(const Config& config, const Motion& motion, float (&speeds)[kWheels]);
  static Motion body_motion(const Config& config, const float (&speeds)[kWheels]);

 private:
  Config config_;
  Ports<Motor> wheels_;
  Port<Remote> remote_;
  Motion motion_;
  Pid loops_[kWheels];
  Time stepped_ = 0;
};

}  // namespace finemote
