// Registers of the analog-to-digital converters.
#pragma once

#include "runtime/boards/robomaster_type_c/registers/register.hpp"

namespace finemote::stm32f407 {

/// ADC3, RM0090 13.13; base 0x40012200: RM0090 2.3 and 13.13.18 (0x200 behind ADC1).
namespace adc3 {
inline constexpr Register sr{0x40012200};                             // 13.13.1
inline constexpr Register cr1{0x40012204};                            // 13.13.2
inline constexpr Register cr2{0x40012208};                            // 13.13.3
inline constexpr Register smpr2{0x40012210};                          // 13.13.5
inline constexpr Register sqr1{0x4001222C}, sqr3{0x40012234};         // 13.13.9, 13.13.11
inline constexpr Register dr{0x4001224C};                             // 13.13.14
inline constexpr std::uint32_t kSrEnd = bit(1), kSrStarted = bit(4);  // 13.13.1
inline constexpr std::uint32_t kCr2On = bit(0), kCr2Start = bit(30);  // 13.13.3
}  // namespace adc3

/// What the three converters share: CCR at 0x40012304, RM0090 13.13.16.
namespace adc {
inline constexpr Register ccr{0x40012304};
inline constexpr std::uint32_t kPrescalerMask = 3U << 16, kPrescalerBy4 = 1U << 16;
}  // namespace adc

}  // namespace finemote::stm32f407
