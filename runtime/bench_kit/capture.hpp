// Counts the clock of a timer over edges of another clock, which the chip can lead to an input of that timer inside.
#pragma once

#include <cstdint>

#include "runtime/chips/stm32f4/peripherals.hpp"

namespace finemote::bench_kit {

/// A clock at an input of a timer. Remaps: RM0090 18.4.20 (TIM5_OR), 19.5.11 (TIM11_OR).
struct CaptureInput {
  stm32f4::TimerPeripheral timer;
  std::uint32_t channel;  ///< 1 to 4
  std::uint32_t remap;    ///< of the timer's option register
};
/// The LSI at channel 4 of TIM5; the crystal divided by RTCPRE at channel 1 of TIM11.
inline constexpr CaptureInput kLsiInput{stm32f4::kTim5, 4, 1U << 6}, kCrystalInput{stm32f4::kTim11, 1, 2U};

/// Edges between two captures: the input's prescaler, RM0090 18.4.7.
inline constexpr std::uint32_t kEdgesPerCapture = 8;

struct Captured {
  std::uint32_t ticks = 0;   ///< of the timer; 0: the edges did not come in time, or too fast to follow
  std::uint32_t cycles = 0;  ///< of the core, meanwhile
};

/// @param captures      whose distances are added up, each below 2^16 ticks
/// @param limit_cycles  for each of them
Captured count_ticks(const CaptureInput& input, std::uint32_t captures, std::uint32_t limit_cycles);

}  // namespace finemote::bench_kit
