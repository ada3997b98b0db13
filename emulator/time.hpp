// The emulator's time: integer steps fine enough for every clock of the board.
#pragma once

#include <cstdint>

namespace finemote::emulator {

/// Time since power-on in steps of 1/42 ns: 168 MHz, 84 MHz, 16 MHz and 12 MHz periods and whole nanoseconds are all
/// integers. 64 bits last for 13 years.
using Time = std::uint64_t;

inline constexpr Time kStepsPerNs = 42;
inline constexpr Time kNever = ~Time{0};

constexpr Time from_ns(std::uint64_t ns) { return ns * kStepsPerNs; }
constexpr std::uint64_t to_ns(Time time) { return time / kStepsPerNs; }
/// Rounded down; up to four months.
constexpr std::uint64_t to_ps(Time time) {
  return time / kStepsPerNs * 1'000 + time % kStepsPerNs * 1'000 / kStepsPerNs;
}

/// Period of a clock, rounded to a step.
constexpr Time period_of(std::uint64_t hz) { return (from_ns(1'000'000'000) + hz / 2) / hz; }
static_assert(period_of(168'000'000) == 250 && period_of(16'000'000) == 2625 && period_of(12'000'000) == 3500);

}  // namespace finemote::emulator
