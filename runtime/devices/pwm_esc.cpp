#include "finemote/devices/pwm_esc.hpp"

namespace finemote {

void PwmEsc::update() {
  state.origin = now();
  state.unreachable = channel_.unreachable();
  state.valid = !state.unreachable;
  state.effort = driven_;
}

void PwmEsc::handle() {
  // The comparison is written so that NaN is out of range.
  const bool usable = is_fresh(command, now(), config_.max_age) && command.effort >= -1 && command.effort <= 1;
  driven_ = usable ? command.effort : 0;
  channel_.set(pulse(driven_));
}

void PwmEsc::safe() {
  const auto neutral = static_cast<std::uint32_t>(config_.neutral);
  channel_.set_safe(neutral);
  channel_.set(neutral);
  driven_ = 0;
}

std::uint32_t PwmEsc::pulse(float effort) const {
  const float way = config_.reverse ? -effort : effort;
  if (way == 0) return static_cast<std::uint32_t>(config_.neutral);
  const auto neutral = static_cast<float>(config_.neutral), dead_zone = static_cast<float>(config_.dead_zone);
  const float end = static_cast<float>(way > 0 ? config_.max : config_.min);
  const float begin = way > 0 ? neutral + dead_zone : neutral - dead_zone;
  const float share = way > 0 ? way : -way;
  return static_cast<std::uint32_t>(begin + share * (end - begin));
}

}  // namespace finemote
