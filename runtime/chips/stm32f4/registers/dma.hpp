// Registers of the two DMA controllers.
#pragma once

#include "runtime/chips/stm32f4/registers/register.hpp"

namespace finemote::stm32f4 {

/// One stream of a controller, RM0090 10.5. DMA1 is at 0x40026000, DMA2 at 0x40026400: RM0090 2.3.
struct DmaStream {
  std::uint32_t controller;  ///< base address
  std::uint32_t number;      ///< 0..7

  [[nodiscard]] constexpr Register cr() const { return Register{base() + 0x00}; }    // 10.5.5
  [[nodiscard]] constexpr Register ndtr() const { return Register{base() + 0x04}; }  // 10.5.6
  [[nodiscard]] constexpr Register par() const { return Register{base() + 0x08}; }   // 10.5.7
  [[nodiscard]] constexpr Register m0ar() const { return Register{base() + 0x0C}; }  // 10.5.8
  [[nodiscard]] constexpr Register fcr() const { return Register{base() + 0x14}; }   // 10.5.10

  /// LISR or HISR, 10.5.1 and 10.5.2: flags of this stream and of three others.
  [[nodiscard]] constexpr Register status() const { return Register{controller + (number / 4) * 4}; }
  /// Flags of this stream as the low six bits.
  [[nodiscard]] std::uint32_t flags() const { return flags_in(status().read()); }
  [[nodiscard]] constexpr std::uint32_t flags_in(std::uint32_t status) const { return (status >> shift()) & 0x3D; }
  /// Clears flags of this stream: LIFCR or HIFCR, 10.5.3 and 10.5.4.
  void clear_flags(std::uint32_t flags) const {
    Register{controller + 0x08 + (number / 4) * 4}.write(flags << shift());
  }

 private:
  [[nodiscard]] constexpr std::uint32_t base() const { return controller + 0x10 + 0x18 * number; }
  /// Position of a stream's flags in its register: 0, 6, 16, 22 for streams 0..3 and 4..7 (10.5.1).
  [[nodiscard]] constexpr std::uint32_t shift() const {
    const std::uint32_t n = number % 4;
    return (n / 2) * 16 + (n % 2) * 6;
  }
};

namespace dma {
inline constexpr std::uint32_t kController1 = 0x40026000, kController2 = 0x40026400;
/// SxCR, RM0090 10.5.5. Data sizes are bytes, the reset value.
inline constexpr std::uint32_t kEnable = bit(0), kDirectErrorInterrupt = bit(1), kErrorInterrupt = bit(2),
                               kHalfInterrupt = bit(3), kCompleteInterrupt = bit(4), kMemoryToPeripheral = bit(6),
                               kCircular = bit(8), kMemoryIncrement = bit(10), kPriorityHigh = 2U << 16,
                               kChannelShift = 25;
/// Flags in the order of LISR, RM0090 10.5.1.
inline constexpr std::uint32_t kFlagFifo = bit(0), kFlagDirect = bit(2), kFlagError = bit(3), kFlagHalf = bit(4),
                               kFlagComplete = bit(5), kFlagsAll = 0x3D;
}  // namespace dma

}  // namespace finemote::stm32f4
