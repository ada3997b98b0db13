// Registers of reset and clock control, power control and the flash interface.
#pragma once

#include "runtime/chips/stm32f4/registers/register.hpp"

namespace finemote::stm32f4 {

/// RCC, RM0090 7.3 (STM32F405/407 variant). Base 0x40023800: RM0090 2.3.
namespace rcc {
inline constexpr Register cr{0x40023800};        // 7.3.1
inline constexpr Register pllcfgr{0x40023804};   // 7.3.2
inline constexpr Register cfgr{0x40023808};      // 7.3.3
inline constexpr Register ahb1rstr{0x40023810};  // 7.3.5
inline constexpr Register apb1rstr{0x40023820};  // 7.3.8
inline constexpr Register apb2rstr{0x40023824};  // 7.3.9
inline constexpr Register ahb1enr{0x40023830};   // 7.3.10
inline constexpr Register apb1enr{0x40023840};   // 7.3.13
inline constexpr Register apb2enr{0x40023844};   // 7.3.14
inline constexpr Register csr{0x40023874};       // 7.3.21

inline constexpr std::uint32_t kCrHsiOn = bit(0), kCrHsiReady = bit(1);
inline constexpr std::uint32_t kCrHseOn = bit(16), kCrHseReady = bit(17), kCrPllOn = bit(24), kCrPllReady = bit(25),
                               kCrAudioPllOn = bit(26), kCrAudioPllReady = bit(27);
inline constexpr std::uint32_t kPllSourceHse = bit(22);
inline constexpr std::uint32_t kCfgrSwitchMask = 3, kCfgrSwitchHsi = 0, kCfgrSwitchPll = 2, kCfgrStatusMask = 3U << 2,
                               kCfgrStatusHsi = 0, kCfgrStatusPll = 2U << 2;
inline constexpr std::uint32_t kCsrLsiOn = bit(0), kCsrLsiReady = bit(1), kCsrRemoveFlags = bit(24),
                               kCsrBrownOut = bit(25), kCsrPinReset = bit(26), kCsrPowerReset = bit(27),
                               kCsrSoftwareReset = bit(28), kCsrIwdgReset = bit(29), kCsrWwdgReset = bit(30);

/// Bits of ahb1enr: ports A..I are bits 0..8.
inline constexpr std::uint32_t kAhb1Crc = bit(12), kAhb1CcmRam = bit(20), kAhb1Dma1 = bit(21), kAhb1Dma2 = bit(22);
/// Bits of apb1enr and apb2enr; those of what serves ports are in peripherals.hpp.
inline constexpr std::uint32_t kApb1Power = bit(28), kApb2Syscfg = bit(14);

/// Turns on a peripheral's clock and reads the register back: ES0182, delay after an RCC peripheral clock enabling.
inline void enable(const Register& enable_register, std::uint32_t bits) {
  enable_register.set(bits);
  static_cast<void>(enable_register.read());
}

/// The reset register that goes with an enable register: the same bits, RM0090 7.3.5 to 7.3.14.
constexpr Register reset_of(const Register& enable_register) { return Register{enable_register.address() - 0x20}; }

/// Puts peripherals of one enable register back into the state after a reset. Not interruptible by whoever resets
/// another one of that register.
inline void restart(const Register& enable_register, std::uint32_t bits) {
  const Register reset = reset_of(enable_register);
  reset.set(bits);
  reset.clear(bits);
}
}  // namespace rcc

/// FLASH, RM0090 3.9.
namespace flash {
inline constexpr Register acr{0x40023C00};  // 3.9.1
inline constexpr std::uint32_t kLatencyMask = 7, kPrefetch = bit(8), kInstructionCache = bit(9), kDataCache = bit(10);
}  // namespace flash

/// PWR, RM0090 5.4.
namespace pwr {
inline constexpr Register cr{0x40007000};   // 5.4.1
inline constexpr Register csr{0x40007004};  // 5.4.2
inline constexpr std::uint32_t kCrScale1 = bit(14), kCsrScaleReady = bit(14);
}  // namespace pwr

}  // namespace finemote::stm32f4
