#include "generator/timing/release_interrupt.hpp"

#include <algorithm>

#include "generator/timing/demand.hpp"

namespace finemote::gen::timing {
namespace {

/// Of more periods than this the common divisor of all stands for the closest pair: it is never longer.
constexpr std::size_t kMostPairs = 64;

/// Multiples of two periods come as close as their common divisor, and no closer.
void look_at_pair(Duration period, Duration other, ReleaseResult& closest) {
  const Duration distance = gcd(period, other);
  if (distance < closest.deadline) closest = {{}, distance, period, other};
}

ReleaseResult closest_releases(const TaskSet& set) {
  const Duration first = set.buckets.front().period;
  ReleaseResult closest{{}, first, first, first};
  if (set.buckets.size() > kMostPairs) {
    for (const TaskBucket& bucket : set.buckets) look_at_pair(closest.deadline, bucket.period, closest);
    return closest;
  }
  for (auto one = set.buckets.begin(); one != set.buckets.end(); ++one) {
    for (auto other = one + 1; other != set.buckets.end(); ++other) look_at_pair(one->period, other->period, closest);
  }
  return closest;
}

}  // namespace

std::optional<ReleaseResult> bound_release(const Model& model, const TaskSet& set, Effort& effort) {
  if (!model.costs.keeps_one_release || set.buckets.empty()) return std::nullopt;
  ReleaseResult release = closest_releases(set);
  if (model.costs.longest_release > Duration::zero() && model.tick < release.deadline) {
    release.deadline = model.tick;
    release.is_in_between = true;
  }
  const std::vector<Stream> buses(set.streams.begin(),
                                  set.streams.begin() + static_cast<std::ptrdiff_t>(set.bus_streams));
  Demand demand(effort);
  demand.add_streams(buses);
  const auto due = static_cast<std::int64_t>(set.buckets.size());
  const Duration base = set.blocking + model.costs.release + due * model.costs.release_per_bucket;
  const Duration end = least_fit(demand, base, std::max(base, nanoseconds(1)), std::max(base, release.deadline));
  if (end != kNever) release.response = end;
  return release;
}

}  // namespace finemote::gen::timing
