#include "finemote/devices/pwm_servo.hpp"

#include <cmath>

#include "finemote/control/numbers.hpp"

namespace finemote {

void PwmServo::update() {
  state.origin = now();
  state.unreachable = channel_.unreachable();
  state.valid = !state.unreachable;
  state.angle = angle_;
}

void PwmServo::handle() {
  if (!is_fresh(command, now(), config_.max_age) || !std::isfinite(command.angle)) return safe();
  angle_ = clamp(command.angle, lowest_, highest_);
  channel_.set(pulse(angle_));
}

void PwmServo::safe() {
  switch (config_.on_loss) {
    case OnLoss::kHold:
      return;
    case OnLoss::kCentre:
      angle_ = clamp(0.0F, lowest_, highest_);
      channel_.set(pulse(angle_));
      return;
    case OnLoss::kRelease:
      channel_.set_safe(0);
      channel_.set(0);
      return;
  }
}

std::uint32_t PwmServo::pulse(float angle) const {
  const auto low = static_cast<float>(static_cast<std::int32_t>(config_.min)),
             high = static_cast<float>(static_cast<std::int32_t>(config_.max));
  const float way = config_.reverse ? -angle : angle;
  const float width = (low + high) / 2 + way / config_.travel * (high - low);
  return static_cast<std::uint32_t>(clamp(width, low, high));
}

}  // namespace finemote
