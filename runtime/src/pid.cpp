#include <cmath>

#include "finemote/control/pid.hpp"

namespace finemote {

float Pid::step(const PidGains& gains, float error, float rate, float dt) {
  if (!std::isfinite(error) || !std::isfinite(rate)) return 0;
  const float wanted = gains.kp * error + integral_ - gains.kd * rate;
  const float growth = gains.ki * error * dt;
  const bool further_out = (wanted > gains.limit && growth > 0) || (wanted < -gains.limit && growth < 0);
  if (!further_out) integral_ = clamp(integral_ + growth, -gains.limit, gains.limit);
  return clamp(wanted, -gains.limit, gains.limit);
}

float wrap_angle(float angle) {
  constexpr float kPi = 3.14159265359F, kTurn = 2 * kPi, kLargest = 1e6F;
  if (!(angle <= kLargest && angle >= -kLargest)) return 0;
  const float turns = angle / kTurn;
  const auto whole = static_cast<std::int32_t>(turns + (turns < 0 ? -0.5F : 0.5F));
  return clamp(angle - static_cast<float>(whole) * kTurn, -kPi, kPi);
}

}  // namespace finemote
