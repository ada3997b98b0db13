#include "finemote/devices/gimbal.hpp"

#include "finemote/control/numbers.hpp"

namespace finemote {

namespace {

void command(const Port<Motor>& motor, const Stamp& from, bool drives, float torque) {
  motor.command.torque = drives ? torque : 0;
  motor.command.origin = from.origin;
  motor.command.valid = drives;
}

}  // namespace

void Gimbal::update() {
  const Time at = now();
  state.origin = oldest(yaw_.state.origin, pitch_.state.origin, imu_.state.origin, remote_.state.origin);
  state.valid = yaw_.state.valid && pitch_.state.valid && imu_.state.valid && remote_.state.valid;
  state.valid = is_fresh(state, at, config_.max_age);
}

void Gimbal::handle() {
  const float dt = step_.next(now());
  const bool drives = state.valid && remote_.state.right_switch != RemoteSwitch::kDown;
  if (!drives || !driving_) {
    yaw_aim_ = imu_.state.yaw;
    pitch_aim_ = imu_.state.pitch;
    yaw_rate_.reset();
    pitch_rate_.reset();
  }
  driving_ = drives;
  if (drives) move_aim(dt);

  const float yaw_wanted = config_.yaw_kp * wrap_angle(yaw_aim_ - imu_.state.yaw);
  const float pitch_wanted = config_.pitch_kp * (pitch_aim_ - imu_.state.pitch);
  const float yaw = yaw_rate_.step({config_.yaw_rate_kp, config_.yaw_rate_ki, 0, config_.max_torque},
                                   yaw_wanted - imu_.state.rate[2], 0, dt);
  const float pitch = pitch_rate_.step({config_.pitch_rate_kp, config_.pitch_rate_ki, 0, config_.max_torque},
                                       pitch_wanted - imu_.state.rate[1], 0, dt);
  command(yaw_, state, drives, yaw_way_ * yaw);
  command(pitch_, state, drives, pitch_way_ * pitch);
}

void Gimbal::move_aim(float dt) {
  yaw_aim_ = wrap_angle(yaw_aim_ - remote_.state.wheel * config_.max_rate * dt);
  if (yaw_range_ != nullptr) {
    const float stands = yaw_way_ * yaw_.state.angle;  // of the turret against the base
    const float ahead = wrap_angle(yaw_aim_ - imu_.state.yaw);
    yaw_aim_ = wrap_angle(imu_.state.yaw + clamp(stands + ahead, yaw_range_->lower, yaw_range_->upper) - stands);
  }
  const float step = -remote_.state.right_y * config_.max_rate * dt;         // positive pitch looks down
  const float at_zero = imu_.state.pitch - pitch_way_ * pitch_.state.angle;  // the head's pitch with the motor at 0
  pitch_aim_ = clamp(pitch_aim_ + step, at_zero + pitch_range_.lower, at_zero + pitch_range_.upper);
}

}  // namespace finemote
