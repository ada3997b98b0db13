#include "emulator/chip/timer.hpp"

namespace finemote::emulator {
namespace {
enum Offset : std::uint32_t {
  kCr1 = 0x00,
  kCr2 = 0x04,
  kSmcr = 0x08,
  kDier = 0x0C,
  kSr = 0x10,
  kEgr = 0x14,
  kCcmr1 = 0x18,
  kCcer = 0x20,
  kCnt = 0x24,
  kPsc = 0x28,
  kArr = 0x2C,
  kRcr = 0x30,
  kCcr1 = 0x34,
  kBdtr = 0x44,
  kDcr = 0x48,
  kLast = 0x50
};
// CR1: RM0090 17.4.1, 18.4.1.
constexpr std::uint32_t kEnable = 1, kNoUpdates = 2, kOnlyOverflow = 4, kOnePulse = 8, kDown = 16, kPreload = 128,
                        kClockDivision = 3U << 8;
constexpr unsigned kFrozen = 0, kForcedLow = 4, kForcedHigh = 5, kPwm1 = 6, kPwm2 = 7;  // CCMR: RM0090 17.4.7
constexpr std::uint32_t kIdleStates = 0x7F00;                                           // CR2: 17.4.2
constexpr std::uint32_t kCompares = 0x1E;                                               // SR, DIER, EGR
constexpr std::uint32_t kInputs = 0x0303, kInputFilters = 0xFCFC;                       // CCMR of inputs
constexpr std::uint32_t kOvercapture = 0x200;                                           // SR, of channel 1
constexpr std::uint32_t kOption = 0x50;
}  // namespace

void Timer::reset() {
  registers_ = {};
  registers_[kArr / 4] = kind_.wide ? 0xFFFFFFFFU : 0xFFFF;
  psc_active_ = held_ = 0;
  arr_active_ = registers_[kArr / 4];
  ccr_active_ = {};
  matched_ = {};
  ++token_;
  ++input_token_;
  update_line();
  announce();
}

/// SMCR: counts on the edges of the first input, the second, or both. 17.4.3.
bool Timer::is_encoder() const {
  const std::uint32_t mode = registers_[kSmcr / 4] & 7;
  return mode >= 1 && mode <= 3;
}

/// 17.3.16: around at the ends, where the direction shows in CR1.
void Timer::turn(int edges) {
  if (!is_encoder() || (registers_[kCr1 / 4] & kEnable) == 0 || edges == 0) return;
  const std::int64_t top = std::int64_t{arr_active_} + 1;
  held_ = static_cast<std::uint32_t>(((std::int64_t{held_} + edges) % top + top) % top);
  registers_[kCr1 / 4] = (registers_[kCr1 / 4] & ~kDown) | (edges < 0 ? kDown : 0);
}

unsigned Timer::mode(unsigned index) const { return registers_[kCcmr1 / 4 + index / 2] >> (index % 2 * 8 + 4) & 7; }

/// @param top  counts of a period
std::uint64_t Timer::width_ns(unsigned index, std::uint32_t compare, std::uint64_t top) const {
  const std::uint64_t before = compare < top ? compare : top;
  const bool low = (registers_[kCcer / 4] >> (4 * index + 1) & 1) != 0;  // CCxP
  const bool begins_active = mode(index) == kPwm1 || mode(index) == kForcedHigh;
  const std::uint64_t active = mode(index) >= kPwm1 ? before : top;
  return to_ns((begins_active != low ? active : top - active) * count_time());
}

Timer::Pulse Timer::pulse(unsigned channel) const {
  const unsigned index = channel - 1;
  const bool output = (registers_[kCcer / 4] >> (4 * index) & 1) != 0;
  const bool main_on = !kind_.advanced || (registers_[kBdtr / 4] >> 15 & 1) != 0;
  if (!output || !counts() || !main_on || mode(index) < kForcedLow) return {};
  const std::uint64_t top = std::uint64_t{arr_active_} + 1;
  return Pulse{width_ns(index, ccr_active_[index], top), to_ns(top * count_time())};
}

void Timer::announce() {
  for (unsigned channel = 1; channel <= 4 && on_pulse; ++channel) {
    const Pulse now = pulse(channel);
    const std::uint64_t key = now.width_ns << 32 ^ now.period_ns;
    if (key != last_[channel - 1]) on_pulse(channel, now);
    last_[channel - 1] = key;
  }
}

/// A line is up while something is flagged and asked for: RM0090 17.4.4, 17.4.5.
void Timer::update_line() {
  const std::uint32_t wanted = registers_[kDier / 4] & registers_[kSr / 4];
  const bool update = (wanted & 1) != 0, compare = (wanted & kCompares) != 0;
  if (update != update_line_) lines_.update(update);
  update_line_ = update;
  if (compare != compare_line_) lines_.compare(compare);
  compare_line_ = compare;
}

/// Flags every compare value the counter has passed since it was flagged last.
void Timer::match_compares() {
  if (!counts()) return;
  const Time now = world_.now(), period = (Time{arr_active_} + 1) * count_time();
  for (unsigned i = 0; i < 4; ++i) {
    if (ccr_active_[i] > arr_active_ || is_input(i)) continue;
    const Time in_lap = zero_ + ccr_active_[i] * count_time();
    const Time last = in_lap <= now ? in_lap : in_lap > period ? in_lap - period : 0;
    if (last <= matched_[i] || last > now) continue;
    matched_[i] = last;
    registers_[kSr / 4] |= 2U << i;
  }
}

/// Looks again when the counter comes to the value, where that is an interrupt.
void Timer::schedule_compare(unsigned index) {
  if (!counts() || (registers_[kDier / 4] >> (index + 1) & 1) == 0 || ccr_active_[index] > arr_active_) return;
  if (is_input(index)) return;
  const Time at = zero_ + ccr_active_[index] * count_time();
  if (at <= matched_[index]) return;
  world_.at(at, [this, token = token_] {
    if (token != token_) return;
    match_compares();
    update_line();
  });
}

/// Preloads take effect; the counter has been 0 since `at`.
void Timer::update_event(Time at) {
  psc_active_ = registers_[kPsc / 4];
  arr_active_ = registers_[kArr / 4];
  for (unsigned i = 0; i < 4; ++i) ccr_active_[i] = registers_[kCcr1 / 4 + i];
  zero_ = at;
  held_ = 0;
}

/// The counter begins again; with UDIS without an update event (RM0090 17.4.1).
void Timer::overflow(Time at) {
  match_compares();
  if ((registers_[kCr1 / 4] & kNoUpdates) != 0) {
    zero_ = at;
  } else {
    update_event(at);
    registers_[kSr / 4] |= 1;
    if ((registers_[kCr1 / 4] & kOnePulse) != 0) registers_[kCr1 / 4] &= ~kEnable;
    update_line();
    announce();
  }
  schedule();
}

void Timer::schedule() {
  ++token_;
  if (!counts() || arr_active_ == 0) return;  // a period of 0 stops the counter: RM0090 17.4.12
  for (unsigned i = 0; i < 4; ++i) schedule_compare(i);
  // A counter that is above its reload value already runs to its end, and begins again without an event: 18.3.1.
  const bool is_past = count() > arr_active_;
  const Time top = is_past ? Time{kind_.wide ? 0xFFFFFFFFU : 0xFFFFU} : Time{arr_active_};
  const Time at = zero_ + (top + 1) * count_time();
  world_.at(at, [this, at, is_past, token = token_] {
    if (token != token_) return;
    if (!is_past) return overflow(at);
    zero_ = at;
    schedule();
  });
}

std::uint32_t Timer::count() const {
  return counts() ? static_cast<std::uint32_t>((world_.now() - zero_) / count_time()) : held_;
}

/// Between two captures of the clock inside; 0: none comes. ICxPSC: every edge, every second, fourth or eighth.
Time Timer::capture_period() const {
  if (!inner_clock_ || !counts()) return 0;
  const unsigned index = inner_clock_->channel - 1;
  const bool is_chosen = (registers_[kOption / 4] & inner_clock_->field) == inner_clock_->choice;
  const bool is_on = (registers_[kCcer / 4] >> (4 * index) & 1) != 0;
  const std::uint32_t input = registers_[kFirstMode + index / 2] >> (index % 2 * 8) & 0xF;
  const std::uint32_t hz = inner_clock_->hz();
  if (!is_chosen || !is_on || (input & 3) != 1 || hz == 0) return 0;
  return period_of(hz) << (input >> 2);
}

/// Begins to follow the clock at the input, whose edges are wherever they are.
void Timer::follow_input() {
  ++input_token_;
  const Time period = capture_period();
  if (period != 0) capture_next((world_.now() / period + 1) * period, period);
}

void Timer::capture_next(Time at, Time period) {
  world_.at(at, [this, at, period, token = input_token_] {
    if (token != input_token_) return;
    capture(at);
    capture_next(at + period, period);
  });
}

/// RM0090 17.3.6: the flag, or with the flag up the one that says that a capture was lost.
void Timer::capture(Time at) {
  const unsigned index = inner_clock_->channel - 1;
  const std::uint32_t flag = 2U << index;
  registers_[kSr / 4] |= (registers_[kSr / 4] & flag) != 0 ? kOvercapture << index : flag;
  registers_[kCcr1 / 4 + index] = static_cast<std::uint32_t>((at - zero_) / count_time());
  update_line();
}

std::uint32_t Timer::read(std::uint32_t offset) {
  if (offset > kLast) return unmodelled_read(offset);
  if (offset == kSr) match_compares();
  if (offset >= kCcr1 && offset < kCcr1 + 16 && is_input((offset - kCcr1) / 4)) {
    registers_[kSr / 4] &= ~(2U << (offset - kCcr1) / 4);
    update_line();
  }
  return offset == kCnt ? count() : registers_[offset / 4];
}

void Timer::write_cr1(std::uint32_t value) {
  const std::uint32_t held = count();
  const bool was = counts();
  registers_[kCr1 / 4] = value;
  if (was && !counts()) held_ = held;
  if (!was && counts()) {
    zero_ = world_.now() - held_ * count_time();
    matched_.fill(world_.now());
  }
  if (was != counts()) schedule();
}

/// What a value asks for that the model does not have.
void Timer::check(std::uint32_t offset, std::uint32_t value) {
  if (offset == kCr1) only(value, kEnable | kNoUpdates | kOnlyOverflow | kOnePulse | kPreload | kClockDivision, "CR1");
  if (offset == kCr2) only(value, kIdleStates, "CR2");
  if (offset == kSmcr) only(value, (value & 7) <= 3 ? 3 : 0, "SMCR");
  if (offset == kDier) only(value, 1 | kCompares, "DIER");
  if (offset == kCcer) only(value, 0x3333 | 0x0888, "CCER");  // no complementary outputs
  if (offset == kRcr) only(value, 0, "RCR");
  if (offset == kBdtr) only(value, 0xAFFF, "BDTR");  // all but the break input and what it ends
  if (offset >= kDcr && offset != kOption) only(value, 0, "DMA");
  if (offset == kOption) only(value, inner_clock_ ? inner_clock_->field : 0, "OR");
  if (offset == kCcmr1 || offset == kCcmr1 + 4) check_modes(offset == kCcmr1 ? 0 : 2, value);
}

/// An encoder's inputs are its own affair; inputs but that of the clock inside, and clearing from outside, are not
/// there.
void Timer::check_modes(unsigned first, std::uint32_t value) {
  if (is_encoder()) return only(value, kInputs | kInputFilters, "CCMR");
  for (unsigned i = 0; i < 2; ++i) {
    const std::uint32_t byte = value >> (8 * i) & 0xFF;
    if (inner_clock_ && inner_clock_->channel == first + i + 1 && (byte & 3) == 1) {
      only(byte, 0xD, "CCMR");  // no filter
      continue;
    }
    only(byte, 0x7C, "CCMR");
    const std::uint32_t mode = byte >> 4 & 7;
    if (mode != kFrozen && mode < kForcedLow) world_.report(Misuse::unmodelled, name() + " compare mode " + hex(mode));
  }
}

void Timer::write(std::uint32_t offset, std::uint32_t value) {
  if (offset > kLast) return unmodelled_write(offset);
  check(offset, value);
  switch (offset) {
    case kCr1:
      write_cr1(value);
      break;
    case kSr:  // rc_w0
      match_compares();
      registers_[kSr / 4] &= value;
      return update_line();
    case kSmcr: {
      const std::uint32_t held = count();
      registers_[kSmcr / 4] = value;
      held_ = held;
      schedule();
      break;
    }
    case kEgr:
      registers_[kSr / 4] |= value & kCompares;
      if ((value & 1) == 0) return update_line();
      update_event(world_.now());
      if ((registers_[kCr1 / 4] & kOnlyOverflow) == 0) registers_[kSr / 4] |= 1;  // URS: RM0090 17.4.1
      update_line();
      schedule();
      break;
    case kCnt:
      held_ = value;
      zero_ = world_.now() - value * count_time();
      schedule();
      break;
    case kDier:
      match_compares();
      registers_[kDier / 4] = value;
      for (unsigned i = 0; i < 4; ++i) schedule_compare(i);
      return update_line();
    case kArr:
      registers_[kArr / 4] = kind_.wide ? value : value & 0xFFFF;
      if ((registers_[kCr1 / 4] & kPreload) == 0) {  // works at once: RM0090 17.3.1
        arr_active_ = registers_[kArr / 4];
        schedule();
      }
      break;
    default:
      registers_[offset / 4] = value;
      break;
  }
  // Without preload a value works at once: RM0090 17.4.7.
  if (offset >= kCcr1 && offset < kCcr1 + 16) {
    const unsigned index = (offset - kCcr1) / 4;
    const std::uint64_t width = width_ns(index, value, std::uint64_t{registers_[kArr / 4]} + 1);
    if (on_compare) on_compare(index + 1, width, newest(world_.crossing()));
    if ((registers_[kCcmr1 / 4 + index / 2] >> (index % 2 * 8 + 3) & 1) == 0) {
      ccr_active_[index] = value;
      schedule_compare(index);
    }
  }
  if (offset == kCr1 || offset == kCcer || offset == kOption || offset / 4 - kFirstMode < 2) follow_input();
  announce();
}

}  // namespace finemote::emulator
