#include "generator/timing/response.hpp"

#include <cmath>

#include "generator/timing/utilization.hpp"

namespace finemote::gen::timing {
namespace {

/// Every fixed point x of x = base + demand(x) is at least base / (1 - U). A start slightly below it saves the many
/// short steps of a nearly saturated processor and cannot pass the least fixed point.
Ns lower_bound(const TaskSet& set, std::size_t w, Ns base) {
  long double rate = 0;
  for (const Stream& s : set.streams) {
    if (s.budgets.empty()) rate += static_cast<long double>(s.cost) / static_cast<long double>(s.separation);
  }
  for (std::size_t v = 0; v < w; ++v) {
    rate += static_cast<long double>(set.buckets[v].cost) / static_cast<long double>(set.buckets[v].period);
  }
  if (rate < 0.5L) return base;
  const long double start = static_cast<long double>(base) / (1 - rate + 1e-12L) * (1 - 1e-6L);
  return start < 9e18L ? std::max(base, static_cast<Ns>(start)) : kNever;
}

/// The stages of one bucket, in the order they run.
class BucketSweep {
 public:
  BucketSweep(const TaskSet& set, std::size_t w, Effort& effort) : bucket_(set.buckets[w]), demand_(effort) {
    demand_.add_streams(set.streams);
    for (std::size_t v = 0; v < w; ++v) demand_.add({0, set.buckets[v].period, set.buckets[v].cost});
    const Ns first = add(set.blocking, bucket_.before);
    x_ = lower_bound(set, w, std::max<Ns>(first, 1));
    good_ = !is_saturated(set, w) && x_ != kNever;
  }

  /// Bound of a stage that ends when `work` of the own bucket is done; kNone from the first miss on.
  Ns end_of(Ns work, bool empty) {
    if (!good_) return kNone;
    const Ns extra = empty ? 1 : 0;
    const Ns base = add(work, extra);
    x_ = least_fit(demand_, base, std::max(x_, base), add(bucket_.period, extra));
    good_ = x_ != kNever;
    return good_ ? x_ - extra : kNone;
  }

 private:
  const TaskBucket& bucket_;
  Demand demand_;
  Ns x_ = 1;
  bool good_ = true;
};

void sweep_bucket(const TaskSet& set, std::size_t w, Effort& effort, Responses& out) {
  const TaskBucket& bucket = set.buckets[w];
  BucketSweep sweep(set, w, effort);
  Ns work = bucket.before;
  for (const Rank d : bucket.devices) {
    out.b_plus[d] = work = add(work, set.update[d]);
    out.r_plus[d] = sweep.end_of(add(work, set.blocking), set.update[d] == 0);
  }
  for (auto d = bucket.devices.rbegin(); d != bucket.devices.rend(); ++d) {
    out.b_minus[*d] = work = add(work, set.handle[*d]);
    out.r_minus[*d] = out.bucket[w] = sweep.end_of(add(work, set.blocking), set.handle[*d] == 0);
  }
  if (bucket.after > 0) out.bucket[w] = sweep.end_of(add(add(work, bucket.after), set.blocking), false);
  if (out.bucket[w] != kNone) return;
  for (const Rank d : bucket.devices) out.r_plus[d] = out.r_minus[d] = kNone;
}

}  // namespace

Responses bound_responses(const TaskSet& set, Effort& effort) {
  const Table<Rank, Ns> nothing(set.update.size()), no_bound(set.update.size(), kNone);
  Responses out{nothing, nothing, no_bound, no_bound, std::vector<Ns>(set.buckets.size(), kNone)};
  for (std::size_t w = 0; w < set.buckets.size(); ++w) sweep_bucket(set, w, effort, out);
  return out;
}

}  // namespace finemote::gen::timing
