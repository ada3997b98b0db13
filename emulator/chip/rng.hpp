// The random number generator: numbers that are the same in every run. RM0090 24.
#pragma once

#include <functional>

#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

class Rng : public Peripheral {
 public:
  /// @param clock_hz  of its own clock, the PLL's output for 48 MHz; 0: there is none
  Rng(World& world, std::function<std::uint32_t()> clock_hz)
      : Peripheral(world, "rng"), clock_hz_(std::move(clock_hz)) {}

  std::uint32_t read(std::uint32_t offset) override {
    if (offset == kCr) return cr_;
    if (offset == kSr) return ready_ ? 1 : 0;
    if (offset != kDr) return unmodelled_read(offset);
    if (!ready_) return 0;
    ready_ = false;
    update();
    begin();
    return number_;
  }
  void write(std::uint32_t offset, std::uint32_t value) override {
    if (offset == kSr) return;  // clears errors, of which there are none
    if (offset != kCr) return unmodelled_write(offset);
    only(value, kOn | kInterrupt, "CR");
    const bool starts = (value & kOn) != 0 && (cr_ & kOn) == 0;
    cr_ = value;
    if ((cr_ & kOn) == 0) ready_ = false;
    if (starts) begin();
    update();
  }
  void reset() override {
    cr_ = 0;
    ready_ = false;
    number_ = 0x2545F491;
    ++token_;
    update();
  }

 private:
  enum Offset : std::uint32_t { kCr = 0, kSr = 4, kDr = 8 };
  static constexpr std::uint32_t kOn = 4, kInterrupt = 8;
  static constexpr int kLine = 80;          // RM0090 12.2, table 62
  static constexpr unsigned kPeriods = 40;  // from one number to the next: 24.1

  void begin() {
    const std::uint32_t hz = clock_hz_();
    if (hz == 0) return world_.report(Misuse::clock, "rng runs without the 48 MHz of the PLL");
    world_.after(kPeriods * period_of(hz), [this, token = ++token_] {
      if (token != token_ || (cr_ & kOn) == 0) return;
      number_ ^= number_ << 13, number_ ^= number_ >> 17, number_ ^= number_ << 5;
      ready_ = true;
      update();
    });
  }
  void update() { world_.set_line(kLine, ready_ && (cr_ & kInterrupt) != 0); }

  std::function<std::uint32_t()> clock_hz_;
  std::uint32_t cr_ = 0, number_ = 0;
  bool ready_ = false;
  std::uint64_t token_ = 0;
};

}  // namespace finemote::emulator
