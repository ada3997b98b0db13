// Monotonic time of the robot: nanoseconds since the first release, which is time 0.
#pragma once

#include <cstdint>

namespace finemote {

/// Nanoseconds since the first release of the buckets. 64 bits: does not wrap in 292 years.
using Time = std::int64_t;

/// A difference of two times in nanoseconds.
using Duration = std::int64_t;

inline constexpr Duration kMicrosecond = 1'000;      ///< ns
inline constexpr Duration kMillisecond = 1'000'000;  ///< ns
inline constexpr Duration kSecond = 1'000'000'000;   ///< ns

/// Stands for when something happened before time began: older than anything that may still be used.
inline constexpr Time kLongAgo = -3600 * kSecond;

/// The present time; 0 before the first release. May be called from everywhere: start-up, stages, interrupts.
Time now();

/// Keeps the processor busy for about `work`, as a stage with that execution time would; more urgent work preempts it.
/// On the host this is what lets virtual time pass. Call it from stages only. Negative durations count as zero.
void busy(Duration work);

/// The earlier of two times: the origin of a value made from both.
constexpr Time oldest(Time a, Time b) { return a < b ? a : b; }

/// The later of two times.
constexpr Time latest(Time a, Time b) { return a < b ? b : a; }

/// The earliest of several times.
template <class... More>
constexpr Time oldest(Time a, Time b, More... more) {
  return oldest(oldest(a, b), more...);
}

}  // namespace finemote
