#include "emulator/chip/adc.hpp"

#include <algorithm>
#include <cmath>

namespace finemote::emulator {
namespace {

enum Offset : std::uint32_t {
  kSr = 0x00,
  kCr1 = 0x04,
  kCr2 = 0x08,
  kSmpr1 = 0x0C,
  kSmpr2 = 0x10,
  kJofr1 = 0x14,
  kSqr1 = 0x2C,
  kSqr3 = 0x34,
  kDr = 0x4C
};
constexpr std::uint32_t kEnd = 1U << 1, kStarted = 1U << 4, kOverrun = 1U << 5;  // SR, 13.13.1
constexpr std::uint32_t kEndInterrupt = 1U << 5, kScan = 1U << 8, kResolution = 3U << 24,
                        kOverrunInterrupt = 1U << 26;  // CR1, 13.13.2
constexpr std::uint32_t kOn = 1, kContinuous = 2, kDma = 1U << 8, kDmaGoesOn = 1U << 9, kEndOfEach = 1U << 10,
                        kLeft = 1U << 11, kTriggers = 3U << 28, kStart = 1U << 30;  // CR2, 13.13.3
constexpr Time kPowerUp = from_ns(3'000);                                           // DS8626 5.3.21, t_STAB
constexpr double kReference = 3.3;

}  // namespace

void Adc::reset() {
  sr_ = cr1_ = cr2_ = dr_ = 0;
  smpr_ = {};
  sqr_ = {};
  kept_ = {};
  converting_ = false;
  ++token_;
  update();
}

void Adc::update() {
  const bool high =
      ((cr1_ & kEndInterrupt) != 0 && (sr_ & kEnd) != 0) || ((cr1_ & kOverrunInterrupt) != 0 && (sr_ & kOverrun) != 0);
  if (high != line_) wiring_.set_line(high);
  line_ = high;
}

/// Sampling time of the input, and a cycle for each bit of the result: 13.5, 13.7, 13.13.4, 13.13.5.
unsigned Adc::cycles(unsigned input) const {
  constexpr unsigned kSampling[] = {3, 15, 28, 56, 84, 112, 144, 480};
  const std::uint32_t field = input < 10 ? smpr_[1] >> (3 * input) : smpr_[0] >> (3 * (input - 10));
  return kSampling[field & 7] + 12 - 2 * (cr1_ >> 24 & 3);
}

/// Without SCAN there is one conversion, whatever the sequence's length: 13.3.6.
unsigned Adc::last_rank() const { return (cr1_ & kScan) != 0 ? sqr_[0] >> 20 & 0xF : 0; }

/// SQR3 holds the first six, SQR1 the last four: 13.13.9 to 13.13.11.
unsigned Adc::input_of(unsigned rank) const { return sqr_[2 - rank / 6] >> (5 * (rank % 6)) & 0x1F; }

void Adc::start() {
  if ((cr2_ & kOn) == 0) return world_.report(Misuse::protocol, name() + " is started while it is off");
  if (world_.now() < ready_at_) world_.report(Misuse::protocol, name() + " is started before it is stable");
  if (converting_) world_.report(Misuse::protocol, name() + " is started while it converts");
  if (clock_period() < period_of(36'000'000)) world_.report(Misuse::clock, name() + " runs above 36 MHz");
  rank_ = 0;
  sr_ |= kStarted;
  convert();
}

void Adc::check_input(unsigned input) {
  if (input >= kInputs) return world_.report(Misuse::protocol, name() + " has no input " + std::to_string(input));
  if (input < kPins && !wiring_.pin_is_analog(input))
    world_.report(Misuse::protocol, name() + " measures a pin that is not analog");
  const bool is_off = input == 18 ? !common_.measures_battery() : input >= kPins && !common_.senses_inside();
  if (is_off) world_.report(Misuse::protocol, name() + " measures inside the chip without being connected to it");
}

void Adc::convert() {
  const unsigned input = input_of(rank_);
  check_input(input);
  converting_ = true;
  world_.after(clock_period() * cycles(input), [this, input, token = ++token_] {
    if (token == token_ && !dead) finish(input);
  });
}

void Adc::finish(unsigned input) {
  converting_ = false;
  ++conversions_;
  const bool is_off = input == 18 ? !common_.measures_battery() : input >= kPins && !common_.senses_inside();
  const double measured = input >= kInputs || is_off ? 0 : volts[input];
  const auto result = std::lround(std::clamp(measured / kReference, 0.0, 1.0) * 4095);
  store(static_cast<std::uint32_t>(result) >> 2 * (cr1_ >> 24 & 3));
  const bool is_last = rank_ == last_rank();
  if (is_last || (cr2_ & kEndOfEach) != 0) sr_ |= kEnd;
  if ((cr2_ & kDma) != 0 && (sr_ & kOverrun) == 0) {
    if (wiring_.dma(wiring_.request)) sr_ &= ~kEnd;
  }
  update();
  rank_ = is_last ? 0 : rank_ + 1;
  if (!is_last || (cr2_ & kContinuous) != 0) convert();
}

/// A result that nobody fetched is an overrun, where somebody has to fetch each; not so by DMA that has come to its end
/// without DDS: 13.8.1, 13.8.2.
void Adc::store(std::uint32_t result) {
  const bool each = (cr2_ & kDma) != 0 ? (cr2_ & kDmaGoesOn) != 0 : (cr2_ & kEndOfEach) != 0;
  if (each && (sr_ & kEnd) != 0) {
    sr_ |= kOverrun;
    return;
  }
  dr_ = (cr2_ & kLeft) != 0 ? result << 4 : result;
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
    case kDr:
      sr_ &= ~kEnd;
      update();
      return dr_;
    default:
      break;
  }
  if (offset >= kSqr1 && offset <= kSqr3) return sqr_[(offset - kSqr1) / 4];
  if (offset >= kJofr1 && offset < kSqr1) return kept_[(offset - kJofr1) / 4 % kept_.size()];
  return unmodelled_read(offset);
}

void Adc::write_control2(std::uint32_t value) {
  only(value, kOn | kContinuous | kDma | kDmaGoesOn | kEndOfEach | kLeft | 0x0F000000 | kStart, "CR2");
  if ((value & kTriggers) != 0) world_.report(Misuse::unmodelled, name() + " trigger of a timer or a pin");
  if ((value & kOn) != 0 && (cr2_ & kOn) == 0) ready_at_ = world_.now() + kPowerUp;
  if ((value & kOn) == 0) {
    converting_ = false;
    ++token_;
  }
  cr2_ = value & ~kStart;
  if ((value & kStart) != 0) start();
}

void Adc::write(std::uint32_t offset, std::uint32_t value) {
  switch (offset) {
    case kSr:
      sr_ &= value;  // rc_w0
      return update();
    case kCr1:
      only(value, kEndInterrupt | kScan | kResolution | kOverrunInterrupt, "CR1");
      cr1_ = value;
      return update();
    case kCr2:
      return write_control2(value);
    case kSmpr1:
    case kSmpr2:
      smpr_[(offset - kSmpr1) / 4] = value;
      return;
    default:
      break;
  }
  if (offset >= kSqr1 && offset <= kSqr3) {
    sqr_[(offset - kSqr1) / 4] = value;
  } else if (offset >= kJofr1 && offset < kSqr1) {
    kept_[(offset - kJofr1) / 4 % kept_.size()] = value;
  } else {
    unmodelled_write(offset);
  }
}

}  // namespace finemote::emulator
