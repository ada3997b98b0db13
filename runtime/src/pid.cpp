#include "finemote/control/pid.hpp"

#include <cmath>

#include "finemote/control/numbers.hpp"

namespace finemote {

float Pid::step(const PidGains& gains, float error, float rate, float dt) {
  if (!std::isfinite(error) || !std::isfinite(rate)) return 0;
  const float wanted = gains.kp * error + integral_ - gains.kd * rate;
  const float growth = gains.ki * error * dt;
  const bool further_out = (wanted > gains.limit && growth > 0) || (wanted < -gains.limit && growth < 0);
  if (!further_out) integral_ = clamp(integral_ + growth, -gains.limit, gains.limit);
  return clamp(wanted, -gains.limit, gains.limit);
}

}  // namespace finemote
