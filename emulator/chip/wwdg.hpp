// The window watchdog, which must be fed neither too late nor too early. RM0090 22.
#pragma once

#include <functional>

#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

class Wwdg : public Peripheral {
 public:
  /// @param clock_hz  of APB1
  Wwdg(World& world, std::function<std::uint32_t()> clock_hz)
      : Peripheral(world, "wwdg"), clock_hz_(std::move(clock_hz)) {}

  std::uint32_t read(std::uint32_t offset) override {
    if (offset == kCr) return count() | (running_ ? kRuns : 0);
    if (offset == kCfr) return cfr_;
    return offset == kSr ? (early_ ? 1 : 0) : unmodelled_read(offset);
  }
  void write(std::uint32_t offset, std::uint32_t value) override {
    if (offset == kCr) return feed(value);
    if (offset == kCfr) {
      cfr_ = (value & 0x3FF) | (cfr_ & kWarns);  // only a reset ends the warnings
    } else if (offset == kSr) {
      early_ = early_ && (value & 1) != 0;
    } else {
      return unmodelled_write(offset);
    }
    update();
  }
  void reset() override {
    cfr_ = 0x7F;
    from_ = 0x7F;
    running_ = early_ = false;
    ++token_;
    update();
  }

  std::function<void()> on_timeout;

 private:
  enum Offset : std::uint32_t { kCr = 0, kCfr = 4, kSr = 8 };
  static constexpr std::uint32_t kRuns = 0x80, kWarns = 0x200, kLast = 0x40;
  static constexpr int kLine = 0;

  [[nodiscard]] Time step() const { return period_of(clock_hz_()) * (4096U << (cfr_ >> 7 & 3)); }
  [[nodiscard]] std::uint32_t count() const {
    if (!running_) return from_;
    return (from_ - static_cast<std::uint32_t>((world_.now() - since_) / step())) & 0x7F;
  }
  void feed(std::uint32_t value) {
    const bool too_early = running_ && count() > (cfr_ & 0x7F);
    running_ = running_ || (value & kRuns) != 0;
    if (running_ && (too_early || (value & kLast) == 0)) return time_out();
    from_ = value & 0x7F;
    since_ = world_.now();
    ++token_;
    if (!running_) return;
    world_.after((from_ - kLast) * step(), [this, token = token_] {
      if (token != token_) return;
      early_ = true;
      update();
    });
    world_.after((from_ - kLast + 1) * step(), [this, token = token_] {
      if (token == token_) time_out();
    });
  }
  void time_out() {
    if (on_timeout) on_timeout();
  }
  void update() { world_.set_line(kLine, early_ && (cfr_ & kWarns) != 0); }

  std::function<std::uint32_t()> clock_hz_;
  std::uint32_t cfr_ = 0x7F, from_ = 0x7F;
  Time since_ = 0;
  bool running_ = false, early_ = false;
  std::uint64_t token_ = 0;
};

}  // namespace finemote::emulator
