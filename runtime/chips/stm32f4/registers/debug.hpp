// Registers of the debug support: what the chip is, and what stops while a debugger holds the core.
#pragma once

#include "runtime/chips/stm32f4/registers/register.hpp"

namespace finemote::stm32f4 {

/// DBGMCU, RM0090 38.16. A power-on resets it, nothing else does.
namespace debug {
inline constexpr Register idcode{0xE0042000};  // 38.6.1
inline constexpr std::uint32_t kDeviceMask = 0xFFF, kStm32f407 = 0x413;
inline constexpr Register apb1_freeze{0xE0042008};  // 38.16.4
inline constexpr std::uint32_t kFreezeWatchdog = bit(12);
}  // namespace debug

}  // namespace finemote::stm32f4
