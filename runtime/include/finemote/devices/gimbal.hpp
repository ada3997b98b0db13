// Turns an operator's stick and the attitude of the head into the torques of a two-axis gimbal.
#pragma once

#include "finemote/contract.hpp"
#include "finemote/control/pid.hpp"
#include "finemote/control/step_time.hpp"
#include "finemote/geometry.hpp"
#include "finemote/interfaces/imu.hpp"
#include "finemote/interfaces/motor.hpp"
#include "finemote/interfaces/remote.hpp"

namespace finemote {

/// The attitude sensor sits on the head: yaw about z, pitch about y, positive looks down. Which way the motors turn is
/// the URDF's where their joints are known; without them yaw turns about z, pitch about y. The wheel moves the yaw
/// aimed at, the right stick's y the pitch (up is away from the operator); the gimbal holds both against the world.
/// Angle loops ask for rates, rate loops for torques. The pitch aimed at is always one the pitch motor reaches within
/// its limits; so is the yaw where its joint has limits. Drives while the right switch is up or in the middle and all
/// inputs are fresh; where it begins to drive it holds what it finds.
class Gimbal {
 public:
  struct Config {
    float max_rate = 3;                                ///< rad/s, of the aim at a full stick
    float pitch_lowest = -0.4F, pitch_highest = 0.5F;  ///< rad, of the head against the turret
    float yaw_kp = 10, yaw_rate_kp = 0.3F, yaw_rate_ki = 1;
    float pitch_kp = 10, pitch_rate_kp = 0.3F, pitch_rate_ki = 1;
    float max_torque = 1.2F;  ///< N m
    Duration max_age = 100 * kMillisecond;
  };

  /// @param yaw_axis, pitch_axis    of the joints; null: z, y
  /// @param yaw_range, pitch_range  about z and y; null: any yaw, the config's pitch
  constexpr Gimbal(const Config& config, const Vector* yaw_axis, const Vector* pitch_axis, const JointRange* yaw_range,
                   const JointRange* pitch_range, Port<Motor> yaw, Port<Motor> pitch, Port<Imu> imu,
                   Port<Remote> remote)
      : config_(config),
        yaw_way_(yaw_axis != nullptr && yaw_axis->z < 0 ? -1.0F : 1.0F),
        pitch_way_(pitch_axis != nullptr && pitch_axis->y < 0 ? -1.0F : 1.0F),
        yaw_range_(yaw_range),
        pitch_range_{pitch_range != nullptr ? *pitch_range : JointRange{config.pitch_lowest, config.pitch_highest}},
        yaw_(yaw),
        pitch_(pitch),
        imu_(imu),
        remote_(remote) {}

  void update();
  void handle();

  Stamp state;  ///< as old as the oldest input, valid while all are

  [[nodiscard]] float yaw_aim() const { return yaw_aim_; }
  [[nodiscard]] float pitch_aim() const { return pitch_aim_; }

 private:
  void move_aim(float dt);

  const Config config_;
  const float yaw_way_, pitch_way_;  ///< 1 or -1: which way the motors turn the head
  const JointRange* yaw_range_;
  const JointRange pitch_range_;  ///< rad, of the head against the turret
  const Port<Motor> yaw_, pitch_;
  const Port<Imu> imu_;
  const Port<Remote> remote_;
  bool driving_ = false;
  float yaw_aim_ = 0, pitch_aim_ = 0;
  Pid yaw_rate_, pitch_rate_;
  StepTime step_;
};

}  // namespace finemote
