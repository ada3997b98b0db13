// Brings the chip from its 16 MHz reset clock to 168 MHz from the board's 12 MHz crystal.
#pragma once

#include <cstdint>

namespace finemote::robomaster_type_c {

inline constexpr std::uint32_t kCrystalHz = 12'000'000;
inline constexpr std::uint32_t kApb1Hz = 42'000'000, kApb2Hz = 84'000'000;
inline constexpr std::uint32_t kApb1TimerHz = 84'000'000,
                               kApb2TimerHz = 168'000'000;  // doubled: RM0090 7.2, timer clocks

/// First thing after reset. Every wait is bounded; a clock that does not come is Module::board with a BoardFault,
/// and does not return.
void start_clock();

}  // namespace finemote::robomaster_type_c
