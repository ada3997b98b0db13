#include "finemote/devices/serial_arm.hpp"

#include "finemote/control/numbers.hpp"

namespace finemote {

namespace {
constexpr float kGravity = 9.80665F;  ///< m/s^2
}  // namespace

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
  if (chain_ != nullptr) weigh();
}

/// From base to tip: how each joint stands. From tip to base: what hangs at it, and how far from its axis.
void SerialArm::weigh() {
  Rotation turned;
  Vector places[kMaxJoints], axes[kMaxJoints], centres[kMaxJoints], place;
  for (unsigned n = 0; n < count(); ++n) {
    place = place + turned * chain_[n].offset;
    places[n] = place;
    axes[n] = turned * chain_[n].axis;
    turned = turned * Rotation::about(chain_[n].axis, joints_[n].state.angle);
    centres[n] = place + turned * chain_[n].centre;
  }
  float mass = 0;
  Vector moment;
  for (unsigned n = count(); n-- > 0;) {
    mass += chain_[n].mass;
    moment = moment + chain_[n].mass * centres[n];
    const Vector lever = moment - mass * places[n];  // times the mass
    weights_[n] = kGravity * (axes[n].x * lever.y - axes[n].y * lever.x);
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
  const float dt = step_.next(now());
  const bool drives = state.valid && remote_.state.right_switch != RemoteSwitch::kDown;
  for (unsigned n = 0; n < count(); ++n) {
    const MotorState& joint = joints_[n].state;
    if (!drives || !driving_) {
      aims_[n] = joint.angle;
      loops_[n].reset();
    }
    const float jogged = aims_[n] + jog(n) * config_.max_speed * dt;
    const float aim = kept_within(ranges_ == nullptr ? nullptr : ranges_ + n, jogged, aims_[n]);
    aims_[n] = clamp(aim, joint.angle - config_.lead, joint.angle + config_.lead);
    MotorCommand& command = joints_[n].command;
    const float most = config_.max_torque, carried = clamp(config_.weight * weights_[n], -most, most);
    const PidGains gains{config_.kp, config_.ki, config_.kd, most - (carried < 0 ? -carried : carried)};
    command.torque = drives ? carried + loops_[n].step(gains, aims_[n] - joint.angle, joint.speed, dt) : 0;
    command.origin = state.origin;
    command.valid = drives;
  }
  driving_ = drives;
}

}  // namespace finemote
