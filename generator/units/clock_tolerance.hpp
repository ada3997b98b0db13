// What a clock counts to how long that can really take, and back, where it is off by a number of parts per million at
// most.
//
// A clock that is off by p runs at (1 - p) to (1 + p) times its rate. Both ends are rounded to the safe side.
#pragma once

#include "generator/units/duration.hpp"

namespace finemote::gen {

inline constexpr std::int64_t kMillion = 1'000'000;

/// The longest time that such a clock may take for `span`: span / (1 - p), rounded up. span >= 0; 0 <= ppm < kMillion.
constexpr Duration longest_time(Duration span, std::int64_t ppm) {
  const std::int64_t whole = floor_div(span, kMillion - ppm).ns(), rest = span.ns() - whole * (kMillion - ppm);
  return span + nanoseconds(whole) * ppm + nanoseconds(ceil_div(rest * ppm, kMillion - ppm));
}

/// The shortest: span * (1 - p), rounded down, which is no more than span / (1 + p). span >= 0; 0 <= ppm <= kMillion.
constexpr Duration shortest_time(Duration span, std::int64_t ppm) {
  const std::int64_t whole = floor_div(span, kMillion).ns(), rest = span.ns() - whole * kMillion;
  return span - nanoseconds(whole) * ppm - nanoseconds(ceil_div(rest * ppm, kMillion));
}

}  // namespace finemote::gen
