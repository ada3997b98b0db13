// Registers of the analog-to-digital converters.
#pragma once

#include "runtime/chips/stm32f4/registers/register.hpp"

namespace finemote::stm32f4 {

/// One converter, RM0090 13.13. ADC1 is at 0x40012000, ADC2 and ADC3 0x100 and 0x200 behind: RM0090 2.3 and 13.13.18.
struct AdcRegisters {
  std::uint32_t base;

  [[nodiscard]] constexpr Register sr() const { return Register{base + 0x00}; }   // 13.13.1
  [[nodiscard]] constexpr Register cr1() const { return Register{base + 0x04}; }  // 13.13.2
  [[nodiscard]] constexpr Register cr2() const { return Register{base + 0x08}; }  // 13.13.3
  /// Sampling times of inputs 10..18 (index 0, 13.13.4) or 0..9 (index 1, 13.13.5).
  [[nodiscard]] constexpr Register smpr(std::uint32_t index) const { return Register{base + 0x0C + 4 * index}; }
  [[nodiscard]] constexpr Register sqr1() const { return Register{base + 0x2C}; }  // 13.13.9
  [[nodiscard]] constexpr Register sqr3() const { return Register{base + 0x34}; }  // 13.13.11
  [[nodiscard]] constexpr Register dr() const { return Register{base + 0x4C}; }    // 13.13.14
};

namespace adc {
inline constexpr std::uint32_t kSrEnd = bit(1), kSrStarted = bit(4);  // 13.13.1
inline constexpr std::uint32_t kCr2On = bit(0), kCr2Start = bit(30);  // 13.13.3
/// What the three converters share: CCR at 0x40012304, RM0090 13.13.16.
inline constexpr Register ccr{0x40012304};
inline constexpr std::uint32_t kPrescalerMask = 3U << 16, kPrescalerBy4 = 1U << 16;
}  // namespace adc

}  // namespace finemote::stm32f4
