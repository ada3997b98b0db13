// Periods to their hyperperiod: the time after which all their releases coincide again.
#pragma once

#include <optional>

#include "generator/units/duration.hpp"

namespace finemote::gen {

/// Least common multiple of two times above 0; none beyond `limit`, or if one of them is none.
constexpr std::optional<Duration> common_multiple(std::optional<Duration> a, std::optional<Duration> b,
                                                  Duration limit = Duration::max()) {
  if (!a || !b) return std::nullopt;
  const std::int64_t factor = floor_div(*a, gcd(*a, *b));
  return factor > floor_div(limit, *b) ? std::nullopt : std::optional(factor * *b);
}

/// Least common multiple of the periods of all elements, 1 ns if there are none; none beyond `limit`.
template <class Periodic>
std::optional<Duration> hyperperiod(const Periodic& all, Duration limit = Duration::max()) {
  std::optional<Duration> common = nanoseconds(1);
  for (const auto& one : all) common = common_multiple(common, one.period, limit);
  return common;
}

/// Two hyperperiods if they are no longer than `limit`, else `limit`: only in the second one are commands as old as
/// they can become.
template <class Periodic>
Duration two_hyperperiods(const Periodic& all, Duration limit) {
  const std::optional<Duration> one = hyperperiod(all, floor_div(limit, 2));
  return one ? 2 * *one : limit;
}

}  // namespace finemote::gen
