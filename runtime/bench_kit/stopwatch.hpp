// Time in cycles of the core, and waits that end by it.
#pragma once

#include <cstdint>

#include "runtime/chips/cortex_m4/core.hpp"
#include "runtime/chips/stm32f4/registers/register.hpp"

namespace finemote::bench_kit {

/// Of the clock the chip starts with, and of the board's: RM0090 7.2.2.
inline constexpr std::uint32_t kResetHz = 16'000'000, kCoreHz = cortex_m4::kCoreHz;

/// Counts from where it is made. From everywhere, once the cycle counter runs.
class Stopwatch {
 public:
  [[nodiscard]] std::uint32_t cycles() const { return cortex_m4::cycles() - begin_; }
  [[nodiscard]] bool has_passed(std::uint32_t cycles_) const { return cycles() >= cycles_; }

 private:
  std::uint32_t begin_ = cortex_m4::cycles();
};

constexpr std::uint32_t cycles_in(std::uint32_t us, std::uint32_t hz = kCoreHz) { return hz / 1'000'000 * us; }

/// Rounded up; up to 25 s at the board's clock.
constexpr std::uint32_t ns_of(std::uint32_t cycles, std::uint32_t hz = kCoreHz) {
  return static_cast<std::uint32_t>((std::uint64_t{cycles} * 1'000'000'000 + hz - 1) / hz);
}

/// Polls until the masked bits have `value`, at most so long. @return whether they had
[[nodiscard]] inline bool wait_until(const stm32f4::Register& status, std::uint32_t mask, std::uint32_t value,
                                     std::uint32_t limit_cycles) {
  const Stopwatch watch;
  do {
    if ((status.read() & mask) == value) return true;
  } while (!watch.has_passed(limit_cycles));
  return (status.read() & mask) == value;
}

}  // namespace finemote::bench_kit
