// The core's 24-bit timer, cycle exact: PM0214 4.5.
#pragma once

#include <cstdint>
#include <functional>

#include "emulator/core/core_clock.hpp"
#include "emulator/core/nvic.hpp"
#include "emulator/event_queue.hpp"

namespace finemote::emulator {

/// Counts down; at 0 it pends its exception, one clock later it takes LOAD again.
class SysTick {
 public:
  SysTick(const CoreClock& clock, EventQueue& queue, Nvic& nvic) : clock_(clock), queue_(queue), nvic_(nvic) {}

  void reset();
  [[nodiscard]] std::uint32_t read(std::uint32_t offset, Time now);  ///< 0 CTRL, 4 LOAD, 8 VAL, 12 CALIB
  void write(std::uint32_t offset, std::uint32_t value, Time now);
  /// The core clock has changed: the count goes on at the new rate.
  void clock_changed(Time now);
  /// A fault: it takes no reload value.
  bool dead = false;

 private:
  [[nodiscard]] Time period() const { return clock_.period() * ((control_ & 4) != 0 ? 1 : 8); }
  [[nodiscard]] std::uint32_t value(Time now) const;
  void load(std::uint32_t count, Time at);
  void reached_zero(std::uint64_t token, Time at);

  const CoreClock& clock_;
  EventQueue& queue_;
  Nvic& nvic_;
  std::uint32_t control_ = 0, load_ = 0;
  bool count_flag_ = false;
  bool counting_ = false;    ///< a zero lies ahead
  std::uint32_t from_ = 0;   ///< the counter was this ...
  Time from_time_ = 0;       ///< ... at this time
  std::uint64_t token_ = 0;  ///< events of older counts are stale
};

}  // namespace finemote::emulator
