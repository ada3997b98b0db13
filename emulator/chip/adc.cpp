#include "emulator/chip/adc.hpp"

#include <algorithm>
#include <cmath>

namespace finemote::emulator {
namespace {

/// The block begins at ADC1; ADC3 is 0x200 behind it, the common registers 0x300: RM0090 13.13.18.
enum Offset : std::uint32_t {
  kSr = 0x200,
  kCr1 = 0x204,
  kCr2 = 0x208,
  kSmpr1 = 0x20C,
  kSmpr2 = 0x210,
  kSqr1 = 0x22C,
  kSqr2 = 0x230,
  kSqr3 = 0x234,
  kDr = 0x24C,
  kCcr = 0x304
};
constexpr std::uint32_t kEnd = 1U << 1, kStarted = 1U << 4;  // SR, 13.13.1
constexpr std::uint32_t kOn = 1, kStart = 1U << 30;          // CR2, 13.13.3
constexpr Time kPowerUp = from_ns(3'000);                    // DS8626 5.3.21, t_STAB
constexpr double kReference = 3.3;

}  // namespace

void Adc::reset() {
  sr_ = cr1_ = cr2_ = dr_ = ccr_ = 0;
  smpr_ = {};
  sqr_ = {};
  converting_ = false;
  ++token_;
}

Time Adc::clock_period() const { return period_of(wiring_.clock_hz()) * (2 * ((ccr_ >> 16 & 3) + 1)); }  // 13.13.16

/// Sampling time of the input and twelve cycles of conversion: 13.5, 13.13.4, 13.13.5.
unsigned Adc::cycles(unsigned input) const {
  constexpr unsigned kSampling[] = {3, 15, 28, 56, 84, 112, 144, 480};
  const std::uint32_t field = input < 10 ? smpr_[1] >> (3 * input) : smpr_[0] >> (3 * (input - 10));
  return kSampling[field & 7] + 12;
}

void Adc::start() {
  const unsigned input = sqr_[2] & 0x1F;
  if ((cr2_ & kOn) == 0) return world_.report(Misuse::protocol, name() + " is started while it is off");
  if (world_.now() < ready_at_) world_.report(Misuse::protocol, name() + " is started before it is stable");
  if (converting_) world_.report(Misuse::protocol, name() + " is started while it converts");
  if (clock_period() < period_of(36'000'000)) world_.report(Misuse::clock, name() + " runs above 36 MHz");
  if (input > 15 || (sqr_[0] >> 20 & 0xF) != 0) return world_.report(Misuse::unmodelled, name() + " sequence");
  if (!wiring_.pin_is_analog(input)) world_.report(Misuse::protocol, name() + " measures a pin that is not analog");
  converting_ = true;
  sr_ |= kStarted;
  world_.after(clock_period() * cycles(input), [this, input, token = ++token_] {
    if (token == token_ && !dead) finish(input);
  });
}

void Adc::finish(unsigned input) {
  converting_ = false;
  ++conversions_;
  dr_ = static_cast<std::uint32_t>(std::lround(std::clamp(volts[input] / kReference, 0.0, 1.0) * 4095));
  sr_ |= kEnd;
}

std::uint32_t Adc::read(std::uint32_t offset) {
  switch (offset) {
    case kSr:
      return sr_;
    case kCr1:
      return cr1_;
    case kCr2:
      return cr2_;
    case kSmpr1:
    case kSmpr2:
      return smpr_[(offset - kSmpr1) / 4];
    case kSqr1:
    case kSqr2:
    case kSqr3:
      return sqr_[(offset - kSqr1) / 4];
    case kDr:
      sr_ &= ~kEnd;
      return dr_;
    case kCcr:
      return ccr_;
    default:
      return unmodelled_read(offset);
  }
}

void Adc::write_control2(std::uint32_t value) {
  only(value, kOn | kStart, "CR2");
  if ((value & kOn) != 0 && (cr2_ & kOn) == 0) ready_at_ = world_.now() + kPowerUp;
  cr2_ = value & ~kStart;
  if ((value & kStart) != 0) start();
}

void Adc::write(std::uint32_t offset, std::uint32_t value) {
  switch (offset) {
    case kSr:
      sr_ &= value;  // rc_w0
      return;
    case kCr1:
      only(value, 0, "CR1");
      cr1_ = value;
      return;
    case kCr2:
      return write_control2(value);
    case kSmpr1:
    case kSmpr2:
      smpr_[(offset - kSmpr1) / 4] = value;
      return;
    case kSqr1:
    case kSqr2:
    case kSqr3:
      sqr_[(offset - kSqr1) / 4] = value;
      return;
    case kCcr:
      only(value, 3U << 16, "CCR");
      ccr_ = value;
      return;
    default:
      return unmodelled_write(offset, value);
  }
}

}  // namespace finemote::emulator
