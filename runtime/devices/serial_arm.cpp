#include "finemote/devices/serial_arm.hpp"

namespace finemote {

namespace {
constexpr float kLongestStep = 0.1F;  ///< s
}

unsigned SerialArm::count() const {
  return joints_.size() < kMaxJoints ? static_cast<unsigned>(joints_.size()) : kMaxJoints;
}

void SerialArm::update() {
  const Time at = now();
  state = {remote_.state.origin, is_fresh(remote_.state, at, config_.max_age)};
  for (unsigned n = 0; n < count(); ++n) {
    state.origin = oldest(state.origin, joints_[n].state.origin);
    state.valid = state.valid && is_fresh(joints_[n].state, at, config_.max_age);
  }
}

/// -1..1: how the operator moves this joint.
float SerialArm::jog(unsigned joint) const {
  const RemoteState& remote = remote_.state;
  const bool tip = remote.left_switch == RemoteSwitch::kDown;
  switch (joint) {
    case 0:
      return remote.right_x;
    case 1:
      return remote.right_y;
    case 2:
      return remote.left_y;
    case 3:
      return remote.left_x;
    case 4:
      return tip ? 0 : remote.wheel;
    case 5:
      return tip ? remote.wheel : 0;
    default:
      return 0;
  }
}

void SerialArm::handle() {
  const Time at = now();
  const float elapsed = seconds(at - stepped_);
  const float dt = elapsed <= kLongestStep ? elapsed : 0;
  stepped_ = at;

  const bool drives = state.valid && remote_.state.right_switch != RemoteSwitch::kDown;
  for (unsigned n = 0; n < count(); ++n) {
    const MotorState& joint = joints_[n].state;
    if (!drives || !driving_) {
      aims_[n] = joint.angle;
      loops_[n].reset();
    }
    aims_[n] =
        clamp(aims_[n] + jog(n) * config_.max_speed * dt, joint.angle - config_.lead, joint.angle + config_.lead);
    MotorCommand& command = joints_[n].command;
    const PidGains gains{config_.kp, config_.ki, config_.kd, config_.max_torque};
    command.torque = drives ? loops_[n].step(gains, aims_[n] - joint.angle, joint.speed, dt) : 0;
    command.origin = state.origin;
    command.valid = drives;
  }
  driving_ = drives;
}

}  // namespace finemote
