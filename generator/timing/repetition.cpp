#include "generator/timing/repetition.hpp"

#include <span>

#include "generator/units/hyperperiod.hpp"

namespace finemote::gen::timing {

std::optional<Duration> hyperperiod_to(const TaskSet& set, std::size_t bucket) {
  return hyperperiod(std::span(set.buckets).first(bucket + 1));
}

std::optional<std::int64_t> releases_per_hyperperiod(const TaskSet& set, std::size_t bucket) {
  const std::optional<Duration> common = hyperperiod_to(set, bucket);
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
