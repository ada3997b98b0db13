// Times with a type of their own: turns "an integer that happens to be nanoseconds" into what only times add to.
//
//   const Duration period = milliseconds(10);
//   const Duration late = 3 * period + microseconds(50);
//   const std::int64_t releases = ceil_div(late, period);
//
// A Duration is made from a number by a name that says its unit, and gives its number by name only. Bits, counts, bytes
// and rates are no times: they stay integers.
#pragma once

#include <compare>
#include <cstdint>
#include <limits>
#include <numeric>

#include "generator/units/checked.hpp"

namespace finemote::gen {

/// A length of time, or a point of it as the time since 0: a whole number of nanoseconds in 64 bits, of either sign.
/// What leaves that range throws Overflow.
class Duration {
 public:
  constexpr Duration() = default;  ///< zero

  /// The number of nanoseconds: for output, and for ratios.
  [[nodiscard]] constexpr std::int64_t ns() const { return ns_; }

  friend constexpr Duration nanoseconds(std::int64_t count);
  static constexpr Duration zero() { return {}; }
  /// The largest and the smallest there is: about 292 years from now and ago.
  static constexpr Duration max() { return Duration(std::numeric_limits<std::int64_t>::max()); }
  static constexpr Duration min() { return Duration(std::numeric_limits<std::int64_t>::min()); }

  friend constexpr bool operator==(Duration, Duration) = default;
  friend constexpr auto operator<=>(Duration, Duration) = default;

  constexpr Duration& operator+=(Duration other) { return ns_ = add(ns_, other.ns_), *this; }
  constexpr Duration& operator-=(Duration other) { return ns_ = subtract(ns_, other.ns_), *this; }
  friend constexpr Duration operator+(Duration a, Duration b) { return a += b; }
  friend constexpr Duration operator-(Duration a, Duration b) { return a -= b; }
  friend constexpr Duration operator-(Duration a) { return zero() - a; }
  friend constexpr Duration operator*(Duration a, std::int64_t count) { return Duration(multiply(a.ns_, count)); }
  friend constexpr Duration operator*(std::int64_t count, Duration a) { return a * count; }

 private:
  constexpr explicit Duration(std::int64_t ns) : ns_(ns) {}

  std::int64_t ns_ = 0;
};

constexpr Duration nanoseconds(std::int64_t count) { return Duration(count); }
constexpr Duration microseconds(std::int64_t count) { return nanoseconds(1'000) * count; }
constexpr Duration milliseconds(std::int64_t count) { return nanoseconds(1'000'000) * count; }
constexpr Duration seconds(std::int64_t count) { return nanoseconds(1'000'000'000) * count; }

/// How many times b fits into a, rounded down or up; b > 0.
constexpr std::int64_t floor_div(Duration a, Duration b) { return floor_div(a.ns(), b.ns()); }
constexpr std::int64_t ceil_div(Duration a, Duration b) { return ceil_div(a.ns(), b.ns()); }

/// One of `count` equal parts, rounded down or up to whole nanoseconds; count > 0.
constexpr Duration floor_div(Duration a, std::int64_t count) { return nanoseconds(floor_div(a.ns(), count)); }
constexpr Duration ceil_div(Duration a, std::int64_t count) { return nanoseconds(ceil_div(a.ns(), count)); }

/// Largest multiple of b that is at most a, and smallest that is at least a; b > 0.
constexpr Duration round_down(Duration a, Duration b) { return nanoseconds(round_down(a.ns(), b.ns())); }
constexpr Duration round_up(Duration a, Duration b) { return nanoseconds(round_up(a.ns(), b.ns())); }

/// Whether a is a whole multiple of b; b > 0.
constexpr bool is_multiple(Duration a, Duration b) { return a.ns() % b.ns() == 0; }

/// Greatest common divisor and least common multiple; a and b > 0.
constexpr Duration gcd(Duration a, Duration b) { return nanoseconds(std::gcd(a.ns(), b.ns())); }
constexpr Duration lcm(Duration a, Duration b) { return nanoseconds(lcm(a.ns(), b.ns())); }

}  // namespace finemote::gen
