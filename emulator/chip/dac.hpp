// The two digital-to-analog converters: the value that software gives is the one put out. RM0090 14.
#pragma once

#include <array>

#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

/// Triggers of timers, waves and DMA are not modelled.
class Dac : public Peripheral {
 public:
  explicit Dac(World& world) : Peripheral(world, "dac") {}

  std::uint32_t read(std::uint32_t offset) override {
    if (offset == kCr) return cr_;
    if (offset == kTrigger || offset == kSr) return 0;
    if (offset == kOutput || offset == kOutput + 4) return output_[(offset - kOutput) / 4];
    if (offset >= kHolding && offset < kOutput) return held_[channel_of(offset)] << shift_of(offset) >> 4;
    return unmodelled_read(offset);
  }
  void write(std::uint32_t offset, std::uint32_t value) override {
    if (offset == kCr) {
      // EN, BOFF, TEN with the trigger of software alone
      only(value, 0x003F003F, "CR");
      cr_ = value;
    } else if (offset == kTrigger) {
      for (unsigned i = 0; i < 2; ++i) {
        if ((value >> i & 1) != 0) output_[i] = held_[i];
      }
    } else if (offset >= kHolding && offset < kBoth) {
      hold(channel_of(offset), value << 4 >> shift_of(offset));
    } else if (offset != kSr) {
      unmodelled_write(offset);
    }
  }
  void reset() override {
    cr_ = 0;
    held_ = output_ = {};
  }

 private:
  enum Offset : std::uint32_t { kCr = 0, kTrigger = 4, kHolding = 8, kBoth = 0x20, kOutput = 0x2C, kSr = 0x34 };

  static unsigned channel_of(std::uint32_t offset) { return (offset - kHolding) / 4 / 3 % 2; }
  /// DHR12R, DHR12L, DHR8R: how far the twelve bits stand to the left, and four.
  static unsigned shift_of(std::uint32_t offset) {
    constexpr unsigned kShifts[] = {4, 8, 0};
    return kShifts[(offset - kHolding) / 4 % 3];
  }
  void hold(unsigned channel, std::uint32_t value) {
    held_[channel] = value & 0xFFF;
    const bool waits = (cr_ >> (16 * channel) & 4) != 0;  // TEN
    if (!waits) output_[channel] = held_[channel];
  }

  std::uint32_t cr_ = 0;
  std::array<std::uint32_t, 2> held_{}, output_{};
};

}  // namespace finemote::emulator
