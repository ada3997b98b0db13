// Brings the chip from its 16 MHz reset clock to the board's clock, by the PLL from the board's crystal.
#pragma once

#include <cstdint>

#include "board/clocks.hpp"

namespace finemote::stm32f4 {

inline constexpr std::uint32_t kApb1Hz = board_clocks::kApb1Hz, kApb2Hz = board_clocks::kApb2Hz;

/// Timers run at twice the clock of their bus when that is divided: RM0090 7.2, timer clocks.
constexpr std::uint32_t timer_hz(std::uint32_t bus_hz) { return bus_hz == board_clocks::kCoreHz ? bus_hz : 2 * bus_hz; }
inline constexpr std::uint32_t kApb1TimerHz = timer_hz(kApb1Hz), kApb2TimerHz = timer_hz(kApb2Hz);

/// First thing after reset. Every wait is bounded; a clock that does not come is Module::board with a BoardFault,
/// and does not return.
void start_clock();

}  // namespace finemote::stm32f4
