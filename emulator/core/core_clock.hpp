// The core clock: how long a cycle is now, and how many have passed.
#pragma once

#include <cstdint>

#include "emulator/time.hpp"

namespace finemote::emulator {

class CoreClock {
 public:
  [[nodiscard]] Time period() const { return period_; }
  [[nodiscard]] std::uint64_t cycles(Time now) const { return base_ + (now - since_) / period_; }

  /// From now on a cycle takes `period`.
  void change(Time now, Time period) {
    base_ = cycles(now);
    since_ = now;
    period_ = period;
  }

 private:
  Time period_ = period_of(16'000'000);  // HSI after reset: RM0090 7.2.2
  Time since_ = 0;
  std::uint64_t base_ = 0;
};

}  // namespace finemote::emulator
