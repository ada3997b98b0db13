#include "emulator/core/systick.hpp"

namespace finemote::emulator {
namespace {
constexpr std::uint32_t kEnable = 1, kInterrupt = 2;
}

void SysTick::reset() {
  control_ = load_ = from_ = 0;
  count_flag_ = counting_ = false;
  ++token_;
}

std::uint32_t SysTick::value(Time now) const {
  if (!counting_) return from_;
  const std::uint64_t passed = (now - from_time_) / period();
  return passed >= from_ ? 0 : static_cast<std::uint32_t>(from_ - passed);
}

std::uint32_t SysTick::read(std::uint32_t offset, Time now) {
  if (offset == 0) {
    const std::uint32_t result = control_ | (count_flag_ ? 1U << 16 : 0);
    count_flag_ = false;
    return result;
  }
  if (offset == 4) return load_;
  if (offset == 8) return value(now);
  return 0;  // CALIB: no reference given
}

/// The counter takes `count` at `at`; LOAD 0 stops it.
void SysTick::load(std::uint32_t count, Time at) {
  ++token_;
  from_ = dead ? 0 : count;
  from_time_ = at;
  counting_ = count != 0 && !dead;
  if (!counting_) return;
  const Time zero = at + count * period();
  queue_.at(zero, [this, token = token_, zero] { reached_zero(token, zero); });
}

void SysTick::reached_zero(std::uint64_t token, Time at) {
  if (token != token_) return;
  count_flag_ = true;
  if ((control_ & kInterrupt) != 0) nvic_.pend(kSysTick);
  const Time reload = at + period();
  queue_.at(reload, [this, token, reload] {
    if (token == token_) load(load_, reload);
  });
}

void SysTick::write(std::uint32_t offset, std::uint32_t value_written, Time now) {
  if (offset == 4) load_ = value_written & 0xFFFFFF;
  if (offset == 8) {  // any write clears the counter; it takes LOAD at the next clock
    count_flag_ = false;
    ++token_;
    counting_ = false;
    from_ = 0;
    if ((control_ & kEnable) != 0) load(load_, now + period());
  }
  if (offset == 0) {
    const bool was = (control_ & kEnable) != 0, on = (value_written & kEnable) != 0;
    const std::uint32_t held = value(now);
    control_ = value_written & 7;
    if (on && !was) load(held != 0 ? held : load_, now + (held != 0 ? 0 : period()));
    if (!on && was) {
      ++token_;
      counting_ = false;
      from_ = held;
    }
  }
}

void SysTick::clock_changed(Time now) {
  if (counting_) load(value(now), now);
}

}  // namespace finemote::emulator
