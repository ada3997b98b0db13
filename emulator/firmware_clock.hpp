// The clock that the boards' firmware runs on, once it has set it up: what its cycle counter counts.
#pragma once

#include "emulator/time.hpp"

namespace finemote::emulator {

inline constexpr std::uint64_t kFirmwareHz = 168'000'000;
inline constexpr std::uint32_t kCycleCounter = 0xE0001004;  ///< DWT_CYCCNT: ARMv7-M C1.8.8

/// 21 cycles are 125 ns.
constexpr std::int64_t cycles_to_ns(std::int64_t cycles) { return cycles * 125 / 21; }
static_assert(cycles_to_ns(kFirmwareHz) == 1'000'000'000);

}  // namespace finemote::emulator
