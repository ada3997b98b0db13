#include "generator/timing/surroundings.hpp"

#include <algorithm>

namespace finemote::gen::timing {

std::size_t SurroundingsHash::operator()(const Surroundings& around) const {
  std::uint64_t hash = around.size();
  for (const Duration d : around) {
    hash = (hash ^ static_cast<std::uint64_t>(d.ns())) * 0x9E3779B97F4A7C15U;
    hash ^= hash >> 29;
  }
  return hash;
}

std::vector<HigherBucket> higher_priority_buckets(const TaskSet& set, std::size_t bucket) {
  std::vector<HigherBucket> higher;
  for (std::size_t v = 0; v < bucket; ++v) {
    const TaskBucket& other = set.buckets[v];
    if (other.cost > Duration::zero()) higher.push_back({other.period, other.cost, Divider(other.period.ns())});
  }
  return higher;
}

SurroundingsFinder::SurroundingsFinder(const TaskSet& set, const Responses& responses, std::size_t bucket,
                                       const std::vector<HigherBucket>& higher, Effort& effort)
    : set_(set),
      period_(set.buckets[bucket].period),
      response_(responses.bucket[bucket]),
      higher_(higher),
      effort_(effort),
      demand_(effort),
      interrupts_(effort) {
  demand_.add_streams(set.streams);
  interrupts_.add_streams(set.streams);
  for (const HigherBucket& u : higher) demand_.add({{}, u.period, u.cost});
  if (!higher.empty()) longest_busy_ = least_fit(demand_, set.blocking, nanoseconds(1), kLongest);
}

const Surroundings& SurroundingsFinder::of(Duration release) {
  around_.clear();
  starts_.clear();
  find_pending(release);
  Duration work = set_.blocking;
  for (std::size_t i = 0; i < pending_.size(); ++i) {
    work += pending_[i].cost;
    const Duration distance = pending_[i].distance;
    if (i + 1 < pending_.size() && pending_[i + 1].distance == distance) continue;
    // Most are ruled out by this: everything since then is done by now.
    if (work + interrupts_.at(distance) > distance) starts_.push_back(distance);
  }
  for (auto distance = starts_.rbegin(); distance != starts_.rend() && !effort_.is_spent(); ++distance) {
    const std::size_t begin = around_.size();
    add_start(release - *distance, release);
    if (!stays_busy(&around_[begin])) around_.resize(begin);
  }
  add_start(release, release);
  return around_;
}

/// What is released before t and may be pending at t, latest first.
void SurroundingsFinder::find_pending(Duration t) {
  pending_.clear();
  for (const HigherBucket& u : higher_) {
    if (gcd(u.period, period_) >= longest_busy_) continue;  // none is that near
    const Duration last = u.by_period.floor((t - nanoseconds(1)).ns()) * u.period;
    for (Duration distance = t - last; distance < longest_busy_ && effort_.spend(kSteps); distance += u.period)
      pending_.push_back({distance, u.cost});
  }
  std::sort(pending_.begin(), pending_.end(),
            [](const Pending& a, const Pending& b) { return a.distance < b.distance; });
}

void SurroundingsFinder::add_start(Duration t0, Duration t) {
  effort_.spend(kSteps * static_cast<std::int64_t>(higher_.size() + 1));
  const Duration horizon = t - t0 + response_ + nanoseconds(2);  // later releases cannot matter
  around_.push_back(t - t0);
  for (const HigherBucket& u : higher_) {
    const Duration first = -u.by_period.floor(-t0.ns()) * u.period;
    around_.push_back(std::min(first - t0, horizon));
  }
}

/// Whether higher-priority jobs released from a start on keep the processor busy beyond the release.
bool SurroundingsFinder::stays_busy(const Duration* start) {
  demand_.begin_at(start + 1);
  return least_fit(demand_, set_.blocking, nanoseconds(1), *start) == kNever;
}

}  // namespace finemote::gen::timing
