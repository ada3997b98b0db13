// Ranges of 32-bit words: what is known of a register or a word in memory.
#pragma once

#include <cstdint>
#include <optional>

namespace finemote::gen::wcet {

/// All words from `low` to `high`, unsigned; never empty.
struct Interval {
  std::uint32_t low = 0;
  std::uint32_t high = UINT32_MAX;

  /// Nothing is known.
  static constexpr Interval any() { return {}; }
  static constexpr Interval of(std::uint32_t value) { return {value, value}; }

  [[nodiscard]] constexpr bool is_constant() const { return low == high; }
  [[nodiscard]] constexpr bool contains(Interval other) const { return low <= other.low && other.high <= high; }
  friend constexpr bool operator==(Interval a, Interval b) { return a.low == b.low && a.high == b.high; }
  friend constexpr bool operator!=(Interval a, Interval b) { return !(a == b); }
};

/// The smallest that holds both.
Interval join(Interval a, Interval b);
/// What both hold; none: nothing.
std::optional<Interval> meet(Interval a, Interval b);

// Results of operations modulo 2^32. Where some results wrap and others do not, nothing is known.
Interval add(Interval a, Interval b);
Interval subtract(Interval a, Interval b);
Interval multiply(Interval a, Interval b);
Interval divide_unsigned(Interval a, Interval b);
Interval bitwise_and(Interval a, Interval b);
Interval bitwise_or(Interval a, Interval b);
Interval exclusive_or(Interval a, Interval b);
Interval complement(Interval a);
/// By 0 to 31 bits.
Interval shift_left(Interval a, unsigned bits);
Interval shift_right(Interval a, unsigned bits);
/// With copies of the sign.
Interval shift_right_signed(Interval a, unsigned bits);

}  // namespace finemote::gen::wcet
