#include "generator/timing/repetition.hpp"

namespace finemote::gen::timing {

std::optional<Duration> common_multiple(std::optional<Duration> a, std::optional<Duration> b) {
  if (!a || !b) return std::nullopt;
  std::int64_t product = 0;
  if (__builtin_mul_overflow(floor_div(*a, gcd(*a, *b)), b->ns(), &product)) return std::nullopt;
  return nanoseconds(product);
}

std::optional<Duration> time_until_repeat(const TaskSet& set, std::size_t bucket) {
  std::optional<Duration> common = set.buckets[bucket].period;
  for (std::size_t v = 0; v < bucket && common; ++v) common = common_multiple(common, set.buckets[v].period);
  return common;
}

std::optional<std::int64_t> releases_until_repeat(const TaskSet& set, std::size_t bucket) {
  const std::optional<Duration> common = time_until_repeat(set, bucket);
  return common ? std::optional(floor_div(*common, set.buckets[bucket].period)) : std::nullopt;
}

std::int64_t most_releases(const TaskSet& set, const Limits& limits) {
  std::int64_t left = limits.releases;
  std::optional<Duration> common = set.buckets.front().period;  // of the highest priority: its releases are all alike
  for (std::size_t w = 1; w < set.buckets.size(); ++w) {
    const Duration period = set.buckets[w].period;
    common = common_multiple(common, period);
    if (!common || floor_div(*common, period) > left) return limits.releases_alone;
    left -= floor_div(*common, period);
  }
  return limits.releases;
}

}  // namespace finemote::gen::timing
