// Registers of an I2C peripheral.
#pragma once

#include "runtime/chips/stm32f4/registers/register.hpp"

namespace finemote::stm32f4 {

/// I2C, RM0090 27.6.
struct I2cRegisters {
  std::uint32_t base;

  [[nodiscard]] constexpr Register cr1() const { return Register{base + 0x00}; }    // 27.6.1
  [[nodiscard]] constexpr Register cr2() const { return Register{base + 0x04}; }    // 27.6.2
  [[nodiscard]] constexpr Register dr() const { return Register{base + 0x10}; }     // 27.6.5
  [[nodiscard]] constexpr Register sr1() const { return Register{base + 0x14}; }    // 27.6.6
  [[nodiscard]] constexpr Register sr2() const { return Register{base + 0x18}; }    // 27.6.7
  [[nodiscard]] constexpr Register ccr() const { return Register{base + 0x1C}; }    // 27.6.8
  [[nodiscard]] constexpr Register trise() const { return Register{base + 0x20}; }  // 27.6.9
};

namespace i2c {
/// CR1, RM0090 27.6.1.
inline constexpr std::uint32_t kOn = bit(0), kStart = bit(8), kStop = bit(9), kAcknowledge = bit(10),
                               kAckNext = bit(11), kSoftwareReset = bit(15);
/// CR2, RM0090 27.6.2: bits 0..5 are the peripheral clock in MHz.
inline constexpr std::uint32_t kErrorInterrupt = bit(8), kEventInterrupt = bit(9), kBufferInterrupt = bit(10);
/// SR1, RM0090 27.6.6.
inline constexpr std::uint32_t kStartSent = bit(0), kAddressSent = bit(1), kByteFinished = bit(2), kReceived = bit(6),
                               kTransmitEmpty = bit(7), kBusError = bit(8), kArbitrationLost = bit(9),
                               kNoAcknowledge = bit(10), kOverrun = bit(11);
inline constexpr std::uint32_t kErrors = kBusError | kArbitrationLost | kNoAcknowledge | kOverrun;
/// SR2, RM0090 27.6.7.
inline constexpr std::uint32_t kMaster = bit(0), kBusy = bit(1);
/// CCR, RM0090 27.6.8.
inline constexpr std::uint32_t kFastMode = bit(15);
}  // namespace i2c

}  // namespace finemote::stm32f4
