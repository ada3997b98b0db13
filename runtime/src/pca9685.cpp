#include "finemote/pca9685.hpp"

#include "finemote/mark.hpp"
#include "finemote/only_after_fault.hpp"
#include "start.hpp"

namespace finemote {

namespace {

// Registers, data sheet table 4.
constexpr std::uint8_t kMode1 = 0x00;
constexpr std::uint8_t kLed0 = 0x06;  ///< ON_L, ON_H, OFF_L, OFF_H of channel 0; the next channel follows
constexpr std::uint8_t kPrescale = 0xFE;

// MODE1, table 5. ALLCALL stays off: its address, 0x70, is that of a TCA9548A.
constexpr std::uint8_t kRestart = 0x80;
constexpr std::uint8_t kAutoIncrement = 0x20;
constexpr std::uint8_t kSleep = 0x10;

constexpr std::uint8_t kFullOff = 0x10;  ///< bit 4 of OFF_H: the output stays low, table 7

constexpr Duration kOscillatorStart = 500 * kMicrosecond;  ///< section 7.3.1.1

constexpr bool runs(std::uint8_t mode) { return (mode & (kSleep | kAutoIncrement)) == kAutoIncrement; }

/// Index of the lowest and of the highest bit of a mask of channels that is not 0.
unsigned lowest(std::uint32_t mask) { return static_cast<unsigned>(__builtin_ctz(mask)); }
unsigned highest(std::uint32_t mask) {
  const unsigned index = 31U - static_cast<unsigned>(__builtin_clz(mask));
  return index < Pca9685::kChannels ? index : Pca9685::kChannels - 1;  // never more, which only this line tells tools
}

}  // namespace

std::uint16_t Pca9685::counts(std::uint32_t pulse) const {
  const std::uint64_t ticks = (std::uint64_t{pulse} * counts_per_ns_ + (std::uint64_t{1} << 31)) >> 32;
  return static_cast<std::uint16_t>(ticks > 4095 ? 4095 : ticks);
}

void Pca9685::flush() {
  const MarkedWork<Work::flush_expander> marked;
  // A flush that we preempt takes our changes along, or the next one does. Once the robot has stopped none goes on, and
  // the safe outputs must not wait for one that was cut off.
  if (busy_.exchange(true) && !detail::has_stopped()) return;
  work();
  busy_.store(false);
}

void Pca9685::work() {
  if (detail::has_stopped()) {  // it may have cut off what had taken changes out and not sent them
    only_after_fault();
    safe_changed_.store(safe_known_.load() != 0);
    changed_.set_bits(used_.load() | safe_known_.load());
  }
  if (may_change_safe() && safe_changed_.exchange(false)) build_safe();
  if (slot_->busy()) return;
  take_result();
  unreachable_.store(slot_->unreachable() || !slot_->bus().ready());
  begin_step();
}

/// What is on the wire must not change. Once the robot has stopped the safe write goes out with every flush, and a
/// right one follows a torn one.
bool Pca9685::may_change_safe() const { return detail::has_stopped() || !(slot_->busy() || slot_->sends_safe()); }

// --------------------------------------------------------------------------------------------------------------
// results

void Pca9685::take_result() {
  const std::uint32_t safe_writes = slot_->safe_writes();
  if (safe_writes != safe_writes_) {  // the bus was recovered: the part shows the safe pulses
    safe_writes_ = safe_writes;
    changed_.set_bits(used_.load());
  }
  if (!started_) return;
  started_ = false;
  if (slot_->done()) return take_step_result();
  changed_.set_bits(in_burst_);
  if (slot_->unreachable()) step_ = Step::kSafe;  // it may have lost its power
}

void Pca9685::take_step_result() {
  switch (step_) {
    case Step::kSafe:
      step_ = Step::kReadMode;
      break;
    case Step::kReadMode:
      mode_ = read_back_;
      step_ = Step::kReadPrescale;
      break;
    case Step::kReadPrescale:
      step_ = runs(mode_) && read_back_ == prescale_ ? Step::kRun : Step::kSleep;
      break;
    case Step::kSleep:
      step_ = Step::kPrescale;
      break;
    case Step::kPrescale:
      step_ = Step::kWake;
      break;
    case Step::kWake:
      awake_ = now();
      step_ = Step::kOscillator;
      break;
    case Step::kOscillator:
      break;
    case Step::kRestart:
      step_ = Step::kSafeAgain;
      break;
    case Step::kSafeAgain:
      changed_.set_bits(used_.load());
      step_ = Step::kRun;
      break;
    case Step::kRun:
      if (checking_ && !runs(read_back_)) step_ = Step::kSafe;
      break;
  }
}

// ----------------------------------------------------------------------------------------------------------------
// steps

void Pca9685::begin_step() {
  in_burst_ = 0;
  checking_ = false;
  if (step_ == Step::kSafe && safe_size_ == 0) step_ = Step::kReadMode;
  if (step_ == Step::kOscillator && now() - awake_ >= kOscillatorStart) step_ = Step::kRestart;
  if (step_ == Step::kSafeAgain && safe_size_ == 0) step_ = Step::kRun;
  switch (step_) {
    case Step::kSafe:
    case Step::kSafeAgain:
      started_ = slot_->start(safe_image_, safe_size_);
      return;
    case Step::kReadMode:
      return read_register(kMode1);
    case Step::kReadPrescale:
      return read_register(kPrescale);
    case Step::kSleep:
      return write_register(kMode1, kSleep | kAutoIncrement);
    case Step::kPrescale:
      return write_register(kPrescale, prescale_);
    case Step::kWake:
      return write_register(kMode1, kAutoIncrement);
    case Step::kOscillator:
      return;
    case Step::kRestart:
      return write_register(kMode1, kRestart | kAutoIncrement);
    case Step::kRun:
      return begin_run();
  }
}

void Pca9685::begin_run() {
  if (++since_check_ >= refresh_) {
    since_check_ = 0;
    checking_ = true;
    changed_.set_bits(used_.load());
  }
  const std::size_t size = build_burst();
  if (checking_) {
    command_[0] = kMode1;
    started_ = slot_->start(command_, 1, &read_back_, 1, burst_, size);
  } else if (size != 0) {
    started_ = slot_->start(burst_, size);
  }
}

void Pca9685::write_register(std::uint8_t address, std::uint8_t value) {
  command_[0] = address;
  command_[1] = value;
  started_ = slot_->start(command_, 2);
}

void Pca9685::read_register(std::uint8_t address) {
  command_[0] = address;
  started_ = slot_->start(command_, 1, &read_back_, 1);
}

// ---------------------------------------------------------------------------------------------------------------
// images

/// Writes the four registers of one channel.
void Pca9685::put(std::uint8_t* at, std::uint32_t pulse) const {
  const std::uint16_t off = counts(pulse);
  at[0] = 0;
  at[1] = 0;
  at[2] = static_cast<std::uint8_t>(off & 0xFF);
  at[3] = pulse == 0 ? kFullOff : static_cast<std::uint8_t>(off >> 8);
}

/// The present one. What has no safe one, and lies between channels that have, keeps it where the safe ones are sent.
/// @param kept_ones  the channels of which that is so
[[gnu::always_inline]] inline void Pca9685::put_pulse(unsigned channel, std::uint32_t kept_ones, std::uint8_t* at) {
  put(at, channel_[channel].pulse.load());
  if ((kept_ones >> channel & 1U) == 0) return;
  std::uint8_t* const kept = safe_image_ + 1 + 4 * (channel - safe_first_);
  kept[2] = at[2];  // the others are 0 in both
  kept[3] = at[3];
}

void Pca9685::build_safe() {
  const std::uint32_t known = safe_known_.load();
  const unsigned first = lowest(known), last = highest(known);
  safe_image_[0] = static_cast<std::uint8_t>(kLed0 + 4 * first);
  for (unsigned n = first; n <= last; ++n) {
    const bool safe = ((known >> n) & 1U) != 0;
    put(safe_image_ + 1 + 4 * (n - first), (safe ? channel_[n].safe : channel_[n].pulse).load());
  }
  safe_size_ = static_cast<std::uint8_t>(1 + 4 * (last - first + 1));
  safe_first_ = static_cast<std::uint8_t>(first);
  kept_ = static_cast<std::uint16_t>((((2U << last) - 1) & ~((1U << first) - 1)) & ~known);
  slot_->set_safe(safe_image_, safe_size_);
}

/// One burst from the first to the last changed channel; its size, 0 when nothing has changed. Channels another bucket
/// sets meanwhile are taken along.
std::size_t Pca9685::build_burst() {
  const std::uint32_t kept = may_change_safe() ? kept_ : 0;
  std::size_t size = 0;
  for (int attempt = 0; attempt < 3; ++attempt) {
    const std::uint32_t changed = changed_.exchange(0);
    if (changed == 0) break;
    in_burst_ |= changed;
    used_.set_bits(changed);
    const unsigned first = lowest(in_burst_), last = highest(in_burst_);
    burst_[0] = static_cast<std::uint8_t>(kLed0 + 4 * first);
    for (unsigned n = first; n <= last; ++n) put_pulse(n, kept, burst_ + 1 + 4 * (n - first));
    size = 1 + 4 * (last - first + 1);
  }
  return size;
}

}  // namespace finemote
