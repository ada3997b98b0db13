// Registers of the general-purpose ports, external interrupts and the system configuration.
#pragma once

#include "runtime/chips/stm32f4/registers/register.hpp"

namespace finemote::stm32f4 {

/// One port of 16 pins, RM0090 8.4. Port A is at 0x40020000, each further one 0x400 on: RM0090 2.3.
struct GpioRegisters {
  std::uint32_t base;

  [[nodiscard]] constexpr Register moder() const { return Register{base + 0x00}; }    // 8.4.1
  [[nodiscard]] constexpr Register otyper() const { return Register{base + 0x04}; }   // 8.4.2
  [[nodiscard]] constexpr Register ospeedr() const { return Register{base + 0x08}; }  // 8.4.3
  [[nodiscard]] constexpr Register pupdr() const { return Register{base + 0x0C}; }    // 8.4.4
  [[nodiscard]] constexpr Register idr() const { return Register{base + 0x10}; }      // 8.4.5
  [[nodiscard]] constexpr Register odr() const { return Register{base + 0x14}; }      // 8.4.6
  [[nodiscard]] constexpr Register bsrr() const { return Register{base + 0x18}; }     // 8.4.7
  /// Alternate functions of pins 0..7 (index 0, 8.4.9) or 8..15 (index 1, 8.4.10).
  [[nodiscard]] constexpr Register afr(std::uint32_t index) const { return Register{base + 0x20 + 4 * index}; }
};

constexpr GpioRegisters gpio(char port) {
  return GpioRegisters{0x40020000 + 0x400 * static_cast<std::uint32_t>(port - 'A')};
}

/// EXTI, RM0090 12.3.
namespace exti {
inline constexpr Register imr{0x40013C00};   // 12.3.1
inline constexpr Register rtsr{0x40013C08};  // 12.3.3
inline constexpr Register ftsr{0x40013C0C};  // 12.3.4
inline constexpr Register pr{0x40013C14};    // 12.3.6
}  // namespace exti

/// SYSCFG: RM0090 9.2.
namespace syscfg {
inline constexpr Register memrmp{0x40013800};  // 9.2.1: what lies at address 0
inline constexpr std::uint32_t kFlashAtZero = 0, kRamAtZero = 3;
/// SYSCFG_EXTICR1..4, 9.2.3 to 9.2.6.
constexpr Register exticr(std::uint32_t index) { return Register{0x40013808 + 4 * index}; }
}  // namespace syscfg

}  // namespace finemote::stm32f4
