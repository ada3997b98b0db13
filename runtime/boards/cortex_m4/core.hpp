// What the shared Cortex-M4 code and the boards agree on: clock, cycle counter, priorities.
#pragma once

#include <cstdint>

namespace finemote::cortex_m4 {

inline constexpr std::uint32_t kCoreHz = 168'000'000;

/// Priority levels of the 16 the chip has (0 is most urgent); the register holds them in the upper four bits.
inline constexpr std::uint8_t kBusPriority = 1;      ///< buses whose data is lost when late
inline constexpr std::uint8_t kSlowBusPriority = 2;  ///< all other bus interrupts
inline constexpr std::uint8_t kReleasePriority = 3;

/// Free-running count of core cycles, 32 bits. From everywhere. Defined by the board.
std::uint32_t cycles();

/// Starts the count at `value`; called once, just before the release timer. Defined by the board.
void start_cycles(std::uint32_t value);

/// Sets priority (level 0..15) of an interrupt line and enables it. For bus drivers, at start.
void enable_line(unsigned line, std::uint8_t level);

}  // namespace finemote::cortex_m4
