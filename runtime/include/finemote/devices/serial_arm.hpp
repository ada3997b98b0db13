// Turns an operator's sticks into joint angles aimed at, and those into the torques of a serial arm's motors.
#pragma once

#include "finemote/contract.hpp"
#include "finemote/control/pid.hpp"
#include "finemote/control/step_time.hpp"
#include "finemote/geometry.hpp"
#include "finemote/interfaces/motor.hpp"
#include "finemote/interfaces/remote.hpp"

namespace finemote {

/// One to eight joints, base to tip, each with an angle loop. Sticks jog: right x, right y, left y, left x move joints
/// 1..4, the wheel joint 5, or joint 6 with the left switch down; further joints hold. Drives while the right switch is
/// up or in the middle and all inputs are fresh; where it begins to drive it holds what it finds. The aim never runs
/// away from the joint by more than `lead`, nor beyond the limits of its joint.
///
/// Where the joints are known, the motors get the torques that carry the arm's weight in its present pose, of the
/// URDF's masses, besides those of their loops. The base link stands upright.
class SerialArm {
 public:
  static constexpr unsigned kMaxJoints = 8;

  struct Config {
    float max_speed = 1;   ///< rad/s, of the aim at a full stick
    float lead = 0.3F;     ///< rad
    float kp = 20;         ///< N m per rad
    float ki = 10;         ///< N m per rad and second
    float kd = 1;          ///< N m per rad/s
    float max_torque = 5;  ///< N m
    float weight = 1;      ///< share of the weight the motors carry, 0..1; less where springs do
    Duration max_age = 100 * kMillisecond;
  };

  /// @param chain   of the joints, in their order; null: nothing is known of its weight
  /// @param ranges  of the joints, in their order; null: they turn without end
  constexpr SerialArm(const Config& config, const ChainLink* chain, const JointRange* ranges, Ports<Motor> joints,
                      Port<Remote> remote)
      : config_(config), chain_(chain), ranges_(ranges), joints_(joints), remote_(remote) {}

  void update();
  void handle();

  Stamp state;  ///< as old as the oldest input, valid while all are

  /// rad; `joint` counts from 0.
  [[nodiscard]] float aim(unsigned joint) const { return joint < kMaxJoints ? aims_[joint] : 0; }
  /// Torque that carries what hangs at the joint [N m]; 0 where nothing is known.
  [[nodiscard]] float weight(unsigned joint) const { return joint < kMaxJoints ? weights_[joint] : 0; }

 private:
  void weigh();
  [[nodiscard]] float jog(unsigned joint) const;
  [[nodiscard]] unsigned count() const;

  const Config config_;
  const ChainLink* chain_;
  const JointRange* ranges_;
  const Ports<Motor> joints_;
  const Port<Remote> remote_;
  bool driving_ = false;
  float aims_[kMaxJoints]{};
  float weights_[kMaxJoints]{};
  Pid loops_[kMaxJoints];
  StepTime step_;
};

}  // namespace finemote
