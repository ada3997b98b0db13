// What the firmware's drivers and its scheduler can hold: the generator refuses more. A test compares these figures
// with the runtime's headers.
#pragma once

#include <cstddef>
#include <cstdint>

namespace finemote::gen::runtime_limits {

/// Longest period [ticks]: finemote::kMaxPeriodTicks.
inline constexpr std::int64_t kPeriodTicks = 0x7FFF'FFFF;

/// Buckets: finemote::kMaxBuckets.
inline constexpr std::size_t kBuckets = 11;

/// Command frames that devices share on one CAN bus: finemote::CanBus::kGroups.
inline constexpr std::size_t kCanGroups = 5;

/// Devices on one CAN bus: finemote::CanBus::kMaxSlots.
inline constexpr std::size_t kCanSlots = 32;

/// Filter banks of a CAN controller, and what one of them accepts: bxCAN in RM0090 32.7.4; CanBus::kMaxIds in all.
inline constexpr std::size_t kCanFilterBanks = 14, kCanIdsPerBank = 4, kCanBlocksPerBank = 2;

/// Devices on one bus of another kind: buses count them in a byte.
inline constexpr std::size_t kSlots = 255;

/// Repetition of a pulse output [ns]: finemote::kShortestPwmPeriod, finemote::kLongestPwmPeriod.
inline constexpr std::int64_t kShortestPwmPeriod = 1'000, kLongestPwmPeriod = 400'000'000;

/// The release timer counts 24 bits of core cycles (SysTick, PM0214 4.5).
inline constexpr std::int64_t kTickCycles = std::int64_t{1} << 24;

}  // namespace finemote::gen::runtime_limits
