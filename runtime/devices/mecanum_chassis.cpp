#include "finemote/devices/mecanum_chassis.hpp"

namespace finemote {

void MecanumChassis::wheel_speeds(const Motion& motion, float (&speeds)[kWheels]) const {
  for (unsigned n = 0; n < kWheels; ++n) {
    const RollingWheel& wheel = rolling_[n];
    speeds[n] =
        (wheel.forward * motion.forward + wheel.left * motion.left + wheel.turn * motion.turn) / config_.wheel_radius;
  }
}

MecanumChassis::Motion MecanumChassis::body_motion(const float (&speeds)[kWheels]) const {
  Motion motion;
  for (unsigned n = 0; n < kWheels; ++n) {
    const float rolled = speeds[n] * config_.wheel_radius;
    motion.forward += rolling_[n].to_forward * rolled;
    motion.left += rolling_[n].to_left * rolled;
    motion.turn += rolling_[n].to_turn * rolled;
  }
  return motion;
}

void MecanumChassis::update() {
  const Time at = now();
  state = {remote_.state.origin, is_fresh(remote_.state, at, config_.max_age)};
  float speeds[kWheels] = {};
  for (unsigned n = 0; n < kWheels; ++n) {
    const MotorState& wheel = wheels_[n].state;
    speeds[n] = wheel.speed;
    state.origin = oldest(state.origin, wheel.origin);
    state.valid = state.valid && is_fresh(wheel, at, config_.max_age);
  }
  motion_ = body_motion(speeds);
}

void MecanumChassis::handle() {
  const Time at = now();
  const RemoteState& remote = remote_.state;
  const bool drives = state.valid && remote.left_switch != RemoteSwitch::kDown;
  const float dt = step_.next(at);

  float wanted[kWheels];
  wheel_speeds(
      {remote.left_y * config_.max_speed, -remote.left_x * config_.max_speed, -remote.right_x * config_.max_turn},
      wanted);
  for (unsigned n = 0; n < kWheels; ++n) {
    MotorCommand& command = wheels_[n].command;
    if (!drives) loops_[n].reset();
    const float error = wanted[n] - wheels_[n].state.speed;
    command.torque = drives ? loops_[n].step({config_.kp, config_.ki, 0, config_.max_torque}, error, 0, dt) : 0;
    command.origin = state.origin;
    command.valid = drives;
  }
}

}  // namespace finemote
