// Registers of the timers.
#pragma once

#include "runtime/chips/stm32f4/registers/register.hpp"

namespace finemote::stm32f4 {

/// TIM1 and TIM8, RM0090 17.4; TIM2 to TIM5, RM0090 18.4; TIM9 to TIM14, RM0090 19.4 and 19.5: same offsets for what is
/// used here.
struct TimerRegisters {
  std::uint32_t base;

  [[nodiscard]] constexpr Register cr1() const { return Register{base + 0x00}; }  // 17.4.1
  [[nodiscard]] constexpr Register egr() const { return Register{base + 0x14}; }  // 17.4.6
  /// Capture/compare mode of channels 1, 2 (index 0, 17.4.7) or 3, 4 (index 1, 17.4.8).
  [[nodiscard]] constexpr Register ccmr(std::uint32_t index) const { return Register{base + 0x18 + 4 * index}; }
  [[nodiscard]] constexpr Register ccer() const { return Register{base + 0x20}; }  // 17.4.9
  [[nodiscard]] constexpr Register psc() const { return Register{base + 0x28}; }   // 17.4.11
  [[nodiscard]] constexpr Register arr() const { return Register{base + 0x2C}; }   // 17.4.12
  /// Compare value of channel 1..4: 17.4.14 to 17.4.17.
  [[nodiscard]] constexpr Register ccr(std::uint32_t channel) const { return Register{base + 0x30 + 4 * channel}; }
  [[nodiscard]] constexpr Register bdtr() const { return Register{base + 0x44}; }  // 17.4.18
};

namespace timer {
inline constexpr std::uint32_t kCr1Enable = bit(0), kCr1PreloadArr = bit(7);  // 17.4.1
inline constexpr std::uint32_t kEgrUpdate = bit(0);                           // 17.4.6
/// One channel's byte of CCMR: PWM mode 1 with preload, 17.4.7.
inline constexpr std::uint32_t kPwmMode1 = 6U << 4 | bit(3);
inline constexpr std::uint32_t kBdtrMainOutput = bit(15);  // 17.4.18
}  // namespace timer

}  // namespace finemote::stm32f4
