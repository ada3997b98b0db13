// Registers of the independent watchdog.
#pragma once

#include "runtime/chips/stm32f4/registers/register.hpp"

namespace finemote::stm32f4 {

/// IWDG, RM0090 21.4. Base 0x40003000: RM0090 2.3.
namespace iwdg {
inline constexpr Register kr{0x40003000};   // 21.4.1
inline constexpr Register pr{0x40003004};   // 21.4.2
inline constexpr Register rlr{0x40003008};  // 21.4.3
inline constexpr Register sr{0x4000300C};   // 21.4.4
inline constexpr std::uint32_t kKeyUnlock = 0x5555, kKeyReload = 0xAAAA, kKeyStart = 0xCCCC;
inline constexpr std::uint32_t kSrPrescalerBusy = bit(0), kSrReloadBusy = bit(1);
}  // namespace iwdg

}  // namespace finemote::stm32f4
