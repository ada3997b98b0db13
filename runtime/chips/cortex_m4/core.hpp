// What the shared Cortex-M4 code and the boards agree on: clock, cycle counter, priorities.
#pragma once

#include <cstdint>
#include <numeric>

#include "board/clocks.hpp"
#include "finemote/mark.hpp"
#include "finemote/time.hpp"

namespace finemote::cortex_m4 {

inline constexpr std::uint32_t kCoreHz = board_clocks::kCoreHz;

/// The smallest whole numbers of cycles and nanoseconds that are equal: at 168 MHz 21 cycles are 125 ns.
inline constexpr std::uint32_t kCyclesPerUnit = kCoreHz / std::gcd(kCoreHz, 1'000'000'000U);
inline constexpr std::uint32_t kNsPerUnit = 1'000'000'000U / std::gcd(kCoreHz, 1'000'000'000U);

/// Priority levels of the 16 the chip has (0 is most urgent); the register holds them in the upper four bits.
inline constexpr std::uint8_t kBusPriority = 1;      ///< buses whose data is lost when late
inline constexpr std::uint8_t kSlowBusPriority = 2;  ///< all other bus interrupts
inline constexpr std::uint8_t kReleasePriority = 3;

/// Free-running count of core cycles, 32 bits, also in idle(). From everywhere. Defined by the board.
std::uint32_t cycles();

/// Starts the count at `value`: once before the buses start, and again just before the release timer. Defined by the
/// board.
void start_cycles(std::uint32_t value);

/// Whether there is a release instant yet. From everywhere.
[[nodiscard]] bool has_begun();

/// Sets priority (level 0..15) of an interrupt line and enables it. For bus drivers, at start.
void enable_line(unsigned line, std::uint8_t level);

/// Keeps all interrupts out while it lives: for the change of a register that an interrupt routine changes, too. No
/// longer than `masked_section` of the board file.
class Masked {
 public:
  [[gnu::always_inline]] Masked() {
    mark<kMark>();
    asm volatile("mrs %0, primask\n\tcpsid i" : "=r"(before_) : : "memory");
  }
  [[gnu::always_inline]] ~Masked() {
    asm volatile("msr primask, %0" : : "r"(before_) : "memory");
    mark<kMark + 1U>();
  }
  Masked(const Masked&) = delete;
  Masked& operator=(const Masked&) = delete;

 private:
  static constexpr std::uint32_t kMark = kFirstWorkMark + 2U * static_cast<std::uint32_t>(Work::masked);

  std::uint32_t before_;
};

/// Cycles between two release instants; for boards that derive cycles() from SysTick.
struct Interval {
  std::uint32_t begin;   ///< count at the last release
  std::uint32_t length;  ///< cycles from there to the next
};
Interval release_interval();

/// Keeps the core busy for `turns` turns of two instructions. 0 returns at once.
inline void spin(std::uint32_t turns) {
  if (turns == 0) return;
  asm volatile("1: subs %0, %0, #1\n\tbne 1b" : "+r"(turns) : : "cc");
}

/// What the core does while no interrupt routine runs. Defined by the board.
[[noreturn]] void idle();

/// Called from the release interrupt once FINEMOTE_RUN_DURATION_NS have passed. Weakly defined as nothing.
void run_ended();

}  // namespace finemote::cortex_m4
