// What the firmware's scheduler and pulse outputs can do: the generator refuses more. A test compares these figures
// with the runtime's headers.
#pragma once

#include <cstddef>
#include <cstdint>

#include "generator/units/duration.hpp"

namespace finemote::gen::runtime_limits {

/// Longest period [ticks]: finemote::kMaxPeriodTicks.
inline constexpr std::int64_t kPeriodTicks = 0x7FFF'FFFF;

/// Buckets: finemote::kMaxBuckets.
inline constexpr std::size_t kBuckets = 11;

/// NVIC priority level of the release, below which buckets run: kReleasePriority of runtime/chips/cortex_m4/core.hpp.
inline constexpr std::uint32_t kReleaseLevel = 3;

/// Release instants of a hyperperiod that the release timer keeps in its ring: one less than kSlots of
/// runtime/chips/cortex_m4/release.cpp. With more it plans each anew.
inline constexpr std::size_t kReleaseInstants = 6;

/// Bytes of the ring that keeps what a serial line receives until update() reads it, finemote::UartRing: at least and
/// at most, both a power of two. Each lap of it interrupts: `min_frame_bits` of `rx_dma` in the chip's file is the
/// least.
inline constexpr std::int64_t kLeastReceiveRing = 256, kMostReceiveRing = 4096;

/// How often one flush of a PWM expander fills its burst at most: Pca9685::build_burst() of runtime/src/pca9685.cpp.
inline constexpr std::int64_t kBursts = 3;

/// Filter banks of a CAN controller, and what one of them accepts: bxCAN in RM0090 32.7.4.
inline constexpr std::size_t kCanFilterBanks = 14, kCanIdsPerBank = 4, kCanBlocksPerBank = 2;

/// Repetition of a pulse output: finemote::kShortestPwmPeriod, finemote::kLongestPwmPeriod.
inline constexpr Duration kShortestPwmPeriod = microseconds(1), kLongestPwmPeriod = milliseconds(400);

/// The release timer counts 24 bits of core cycles (SysTick, PM0214 4.5).
inline constexpr std::int64_t kTickCycles = std::int64_t{1} << 24;

}  // namespace finemote::gen::runtime_limits
