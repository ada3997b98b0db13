// Turns an operator's sticks into the torques of four mecanum wheels, and the wheels' speeds into the body's motion.
#pragma once

#include "finemote/contract.hpp"
#include "finemote/control/pid.hpp"
#include "finemote/control/step_time.hpp"
#include "finemote/geometry.hpp"
#include "finemote/interfaces/motor.hpp"
#include "finemote/interfaces/remote.hpp"

namespace finemote {

/// Frame x forward, y left, z up; rollers as an X seen from above. Where the wheels' joints are known, places and ways
/// of turning are the URDF's, in any order. Without them the wheels come front left, front right, rear left, rear
/// right, at the corners of a rectangle of `reach`, and every motor turns positive when its wheel rolls forward.
///
/// The left stick moves, the right stick's x turns. Drives while the left switch is up or in the middle; with the
/// switch down, or without fresh data of remote and wheels, the commands are invalid and the motors stop by themselves.
/// Each wheel has a speed loop in real units. What the motors get is as old as the oldest input.
class MecanumChassis {
 public:
  static constexpr unsigned kWheels = 4;

  struct Config {
    float wheel_radius = 0.076F;  ///< m
    float reach = 0.4F;           ///< m, half wheelbase plus half track, of wheels without joints
    float max_speed = 2;          ///< m/s, at a full stick
    float max_turn = 4;           ///< rad/s
    float kp = 0.1F;              ///< N m per rad/s of wheel speed
    float ki = 0.5F;              ///< N m per rad
    float max_torque = 3;         ///< N m per wheel
    Duration max_age = 100 * kMillisecond;
  };

  /// @param rolling  of the wheels, in their order; null: a rectangle of `reach`
  constexpr MecanumChassis(const Config& config, const RollingWheel* rolling, Ports<Motor> wheels, Port<Remote> remote)
      : config_(config), rolling_{}, wheels_(wheels), remote_(remote) {
    for (unsigned n = 0; n < kWheels; ++n) rolling_[n] = rolling != nullptr ? rolling[n] : corner(n, config.reach);
  }

  void update();
  void handle();

  Stamp state;  ///< as old as the oldest input, valid while all are

  /// Motion of the body from the wheels: m/s forward, m/s to the left, rad/s.
  struct Motion {
    float forward = 0, left = 0, turn = 0;
  };
  [[nodiscard]] const Motion& motion() const { return motion_; }

  /// Wheel speeds [rad/s] for a motion, in the order of the wheels.
  void wheel_speeds(const Motion& motion, float (&speeds)[kWheels]) const;
  [[nodiscard]] Motion body_motion(const float (&speeds)[kWheels]) const;

 private:
  /// Of a rectangle: front left, front right, rear left, rear right.
  static constexpr RollingWheel corner(unsigned n, float reach) {
    const float left = n == 0 || n == 3 ? -1 : 1, turn = n == 0 || n == 2 ? -1 : 1;
    return {1, left, turn * reach, 0.25F, left / 4, turn / (4 * reach)};
  }

  const Config config_;
  RollingWheel rolling_[kWheels];
  const Ports<Motor> wheels_;
  const Port<Remote> remote_;
  Motion motion_;
  Pid loops_[kWheels];
  StepTime step_;
};

}  // namespace finemote
