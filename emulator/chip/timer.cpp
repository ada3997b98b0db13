#include "emulator/chip/timer.hpp"

namespace finemote::emulator {
namespace {
enum Offset : std::uint32_t {
  kCr1 = 0x00,
  kDier = 0x0C,
  kSr = 0x10,
  kEgr = 0x14,
  kCcmr1 = 0x18,
  kCcer = 0x20,
  kCnt = 0x24,
  kPsc = 0x28,
  kArr = 0x2C,
  kCcr1 = 0x34,
  kBdtr = 0x44,
  kLast = 0x50
};
}

void Timer::reset() {
  registers_ = {};
  registers_[kArr / 4] = 0xFFFF;
  psc_active_ = 0;
  arr_active_ = 0xFFFF;
  ccr_active_ = {};
  ++token_;
  world_.set_line(update_line_, false);
}

Timer::Pulse Timer::pulse(unsigned channel) const {
  const unsigned index = channel - 1;
  const std::uint32_t mode = registers_[kCcmr1 / 4 + index / 2] >> (index % 2 * 8 + 4) & 7;
  const bool output = (registers_[kCcer / 4] >> (4 * index) & 1) != 0, counting = (registers_[kCr1 / 4] & 1) != 0;
  const bool main_on = !advanced_ || (registers_[kBdtr / 4] >> 15 & 1) != 0;
  if (!output || !counting || !main_on || mode != 6) return {};
  const std::uint32_t top = arr_active_ + 1, high = ccr_active_[index] < top ? ccr_active_[index] : top;
  return Pulse{to_ns(high * count_time()), to_ns(top * count_time())};
}

void Timer::announce() {
  for (unsigned channel = 1; channel <= 4 && on_pulse; ++channel) {
    const Pulse now = pulse(channel);
    const std::uint64_t key = now.width_ns << 32 ^ now.period_ns;
    if (key != last_[channel - 1]) on_pulse(channel, now);
    last_[channel - 1] = key;
  }
}

void Timer::update_event() {
  psc_active_ = registers_[kPsc / 4];
  arr_active_ = registers_[kArr / 4];
  for (unsigned i = 0; i < 4; ++i) ccr_active_[i] = registers_[kCcr1 / 4 + i];
  zero_ = world_.now();
  registers_[kSr / 4] |= 1;
  if ((registers_[kDier / 4] & 1) != 0) world_.set_line(update_line_, true);
  announce();
  schedule();
}

void Timer::schedule() {
  ++token_;
  if ((registers_[kCr1 / 4] & 1) == 0) return;
  world_.at(zero_ + (Time{arr_active_} + 1) * count_time(), [this, token = token_] {
    if (token == token_) update_event();
  });
}

std::uint32_t Timer::read(std::uint32_t offset) {
  if (offset > kLast) return unmodelled_read(offset);
  if (offset == kCnt && (registers_[kCr1 / 4] & 1) != 0)
    return static_cast<std::uint32_t>((world_.now() - zero_) / count_time());
  return registers_[offset / 4];
}

void Timer::write(std::uint32_t offset, std::uint32_t value) {
  if (offset > kLast) return unmodelled_write(offset, value);
  if (offset == kSr) {
    registers_[kSr / 4] &= value;
    if ((registers_[kSr / 4] & 1) == 0) world_.set_line(update_line_, false);
    return;
  }
  if (offset == kEgr) {
    if ((value & 1) != 0) update_event();
    return;
  }
  const bool was = (registers_[kCr1 / 4] & 1) != 0;
  registers_[offset / 4] = value;
  if (offset == kCr1 && !was && (value & 1) != 0) {
    zero_ = world_.now();
    arr_active_ = registers_[kArr / 4];
    schedule();
  }
  // Without preload a value works at once: RM0090 17.3.1, 17.4.7.
  if (offset >= kCcr1 && offset < kCcr1 + 16) {
    const unsigned index = (offset - kCcr1) / 4;
    if ((registers_[kCcmr1 / 4 + index / 2] >> (index % 2 * 8 + 3) & 1) == 0) ccr_active_[index] = value;
  }
  announce();
}

}  // namespace finemote::emulator
