#include "generator/timing/response.hpp"

#include <cmath>

#include "generator/timing/utilization.hpp"

namespace finemote::gen::timing {
namespace {

/// Every fixed point x of x = base + demand(x) is at least base / (1 - U). A start slightly below it saves the many
/// short steps of a nearly saturated processor and cannot pass the least fixed point.
Duration lower_bound(const TaskSet& set, std::size_t w, Duration base) {
  long double rate = 0;
  for (const Stream& s : set.streams) {
    if (s.budgets.empty()) rate += static_cast<long double>(s.cost.ns()) / static_cast<long double>(s.separation.ns());
  }
  for (std::size_t v = 0; v < w; ++v) {
    rate += static_cast<long double>(set.buckets[v].cost.ns()) / static_cast<long double>(set.buckets[v].period.ns());
  }
  if (rate < 0.5L) return base;
  const long double start = static_cast<long double>(base.ns()) / (1 - rate + 1e-12L) * (1 - 1e-6L);
  return start < 9e18L ? std::max(base, nanoseconds(static_cast<std::int64_t>(start))) : kNever;
}

/// The stages of one bucket, in the order they run.
class BucketSweep {
 public:
  BucketSweep(const TaskSet& set, std::size_t w, Effort& effort)
      : set_(set), w_(w), bucket_(set.buckets[w]), demand_(effort) {
    demand_.add_streams(set.in_job(w));
    for (std::size_t v = 0; v < w; ++v) demand_.add({{}, set.buckets[v].period, set.buckets[v].cost});
    const Duration first = set.blocking + bucket_.before;
    x_ = lower_bound(set, w, std::max(first, nanoseconds(1)));
    good_ = !is_saturated(set, w) && x_ != kNever;
  }

  /// Bound of the stage at this place, which ends when `work` of the own bucket is done; kNone from the first miss on.
  Duration end_of(std::size_t place, Duration work, bool empty) {
    if (!good_) return kNone;
    demand_.run({0, place});
    const Duration extra = nanoseconds(empty ? 1 : 0);
    const Duration base = work + extra;
    x_ = least_fit(demand_, base, std::max(x_, base), bucket_.period + extra);
    if (demand_.is_spent()) {
      is_closed_form_ = true;
      x_ = closed_fixed_point(set_, w_, base);
    }
    good_ = x_ != kNever && x_ <= bucket_.period + extra;
    return good_ ? x_ - extra : kNone;
  }

  [[nodiscard]] bool is_closed_form() const { return is_closed_form_; }

 private:
  const TaskSet& set_;
  std::size_t w_;
  const TaskBucket& bucket_;
  Demand demand_;  ///< all higher-priority demand
  Duration x_ = nanoseconds(1);
  bool good_ = true;
  bool is_closed_form_ = false;
};

void sweep_bucket(const TaskSet& set, std::size_t w, Effort& effort, Responses& out) {
  const TaskBucket& bucket = set.buckets[w];
  BucketSweep sweep(set, w, effort);
  Duration work = bucket.before;
  for (const Rank d : bucket.devices) {
    out.b_plus[d] = work += set.update[d];
    out.r_plus[d] = sweep.end_of(set.update_place(d), work + set.blocking, set.update[d] == Duration::zero());
  }
  for (auto d = bucket.devices.rbegin(); d != bucket.devices.rend(); ++d) {
    out.b_minus[*d] = work += set.handle[*d];
    out.r_minus[*d] = sweep.end_of(set.handle_place(*d), work + set.blocking, set.handle[*d] == Duration::zero());
  }
  // Also where no flush takes time: something may say that it asks.
  const bool is_empty = bucket.after == Duration::zero() && set.handle[bucket.devices.front()] == Duration::zero();
  out.bucket[w] = sweep.end_of(set.flush_place(w), work + bucket.after + set.blocking, is_empty);
  out.closed_form[w] = sweep.is_closed_form();
  if (out.bucket[w] != kNone) return;
  for (const Rank d : bucket.devices) out.r_plus[d] = out.r_minus[d] = kNone;
}

}  // namespace

Responses bound_responses(const TaskSet& set, Effort& effort) {
  const Table<Rank, Duration> nothing(set.update.size()), no_bound(set.update.size(), kNone);
  Responses out{nothing,
                nothing,
                no_bound,
                no_bound,
                std::vector<Duration>(set.buckets.size(), kNone),
                std::vector<bool>(set.buckets.size(), false)};
  for (std::size_t w = 0; w < set.buckets.size(); ++w) sweep_bucket(set, w, effort, out);
  return out;
}

}  // namespace finemote::gen::timing
