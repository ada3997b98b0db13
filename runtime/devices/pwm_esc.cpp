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
  const bool usable = is_fresh(command, now(), max_age_) && command.effort >= -1 && command.effort <= 1;
  driven_ = usable ? command.effort : 0;
  channel_.set(pulse(driven_));
}

void PwmEsc::safe() {
  const auto neutral = static_cast<std::uint32_t>(neutral_);
  channel_.set_safe(neutral);
  channel_.set(neutral);
  driven_ = 0;
}

std::uint32_t PwmEsc::pulse(float effort) const {
  const float way = reverse_ ? -effort : effort;
  if (way == 0) return static_cast<std::uint32_t>(neutral_);
  const std::int32_t range = way > 0 ? max_ - neutral_ : neutral_ - min_;
  const std::int32_t least = dead_zone_ < range ? dead_zone_ : range;
  const float share = way > 0 ? way : -way;
  const std::int32_t off = least + static_cast<std::int32_t>(share * static_cast<float>(range - least));
  return static_cast<std::uint32_t>(way > 0 ? neutral_ + off : neutral_ - off);
}

}  // namespace finemote
