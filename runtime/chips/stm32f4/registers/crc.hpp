// Registers of the checksum unit: CRC-32 of words, polynomial 0x04C11DB7, from all ones. RM0090 4.
#pragma once

#include "runtime/chips/stm32f4/registers/register.hpp"

namespace finemote::stm32f4::crc {

inline constexpr Register dr{0x40023000};  // 4.4.1
inline constexpr Register cr{0x40023008};  // 4.4.3
inline constexpr std::uint32_t kReset = 1;

}  // namespace finemote::stm32f4::crc
