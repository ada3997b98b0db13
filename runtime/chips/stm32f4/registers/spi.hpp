// Registers of an SPI peripheral.
#pragma once

#include "runtime/chips/stm32f4/registers/register.hpp"

namespace finemote::stm32f4 {

/// SPI, RM0090 28.5.
struct SpiRegisters {
  std::uint32_t base;

  [[nodiscard]] constexpr Register cr1() const { return Register{base + 0x00}; }  // 28.5.1
  [[nodiscard]] constexpr Register cr2() const { return Register{base + 0x04}; }  // 28.5.2
  [[nodiscard]] constexpr Register sr() const { return Register{base + 0x08}; }   // 28.5.3
  [[nodiscard]] constexpr Register dr() const { return Register{base + 0x0C}; }   // 28.5.4
};

namespace spi {
/// CR1: bits 0 and 1 are phase and polarity, bits 3 to 5 divide the clock by 2 << n.
inline constexpr std::uint32_t kMaster = bit(2), kDividerShift = 3, kOn = bit(6), kSelectHigh = bit(8),
                               kSelectBySoftware = bit(9);
/// CR2.
inline constexpr std::uint32_t kDmaReceive = bit(0), kDmaTransmit = bit(1), kReceiveInterrupt = bit(6);
/// SR.
inline constexpr std::uint32_t kReceived = bit(0), kTransmitEmpty = bit(1), kOverrun = bit(6), kBusy = bit(7);
}  // namespace spi

}  // namespace finemote::stm32f4
