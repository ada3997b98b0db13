// Registers of a USART.
#pragma once

#include "runtime/chips/stm32f4/registers/register.hpp"

namespace finemote::stm32f4 {

/// USART, RM0090 30.6.
struct UsartRegisters {
  std::uint32_t base;

  [[nodiscard]] constexpr Register sr() const { return Register{base + 0x00}; }   // 30.6.1
  [[nodiscard]] constexpr Register dr() const { return Register{base + 0x04}; }   // 30.6.2
  [[nodiscard]] constexpr Register brr() const { return Register{base + 0x08}; }  // 30.6.3
  [[nodiscard]] constexpr Register cr1() const { return Register{base + 0x0C}; }  // 30.6.4
  [[nodiscard]] constexpr Register cr2() const { return Register{base + 0x10}; }  // 30.6.5
  [[nodiscard]] constexpr Register cr3() const { return Register{base + 0x14}; }  // 30.6.6
};

namespace usart {
/// SR, RM0090 30.6.1.
inline constexpr std::uint32_t kParityError = bit(0), kFramingError = bit(1), kNoise = bit(2), kOverrun = bit(3),
                               kIdle = bit(4), kReceived = bit(5), kTransmitComplete = bit(6), kTransmitEmpty = bit(7);
inline constexpr std::uint32_t kErrors = kParityError | kFramingError | kNoise | kOverrun;
/// CR1, RM0090 30.6.4.
inline constexpr std::uint32_t kReceiverOn = bit(2), kTransmitterOn = bit(3), kIdleInterrupt = bit(4),
                               kCompleteInterrupt = bit(6), kParityInterrupt = bit(8), kOddParity = bit(9),
                               kParityOn = bit(10), kNineBits = bit(12), kOn = bit(13);
/// CR2, RM0090 30.6.5: STOP = 10 is two stop bits.
inline constexpr std::uint32_t kTwoStopBits = 2U << 12;
/// CR3, RM0090 30.6.6.
inline constexpr std::uint32_t kErrorInterrupt = bit(0), kDmaReceive = bit(6), kDmaTransmit = bit(7);
}  // namespace usart

}  // namespace finemote::stm32f4
