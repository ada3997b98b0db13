// What is released around one release of a bucket: all that its bounds depend on.
#pragma once

#include "generator/timing/response.hpp"
#include "generator/units/divider.hpp"

namespace finemote::gen::timing {

/// The instants t0 from which higher-priority jobs may be pending at a release t, earliest first and the release itself
/// last. Each is a row of numbers: its distance t - t0, then per higher-priority bucket its first release at or after
/// t0, less t0. Releases with the same surroundings have the same bounds.
using Surroundings = std::vector<Duration>;

struct SurroundingsHash {
  std::size_t operator()(const Surroundings& around) const;
};

/// A higher-priority bucket: of a shorter period and nonzero cost.
struct HigherBucket {
  Duration period = nanoseconds(1);
  Duration cost;
  Divider by_period;
};

/// The higher-priority buckets of a bucket, the highest priority first.
std::vector<HigherBucket> higher_priority_buckets(const TaskSet& set, std::size_t bucket);

/// Finds the surroundings of one release after the other. When the steps are spent, they are incomplete.
class SurroundingsFinder {
 public:
  /// Everything must outlive this; the bucket is ok.
  SurroundingsFinder(const TaskSet& set, const Responses& responses, std::size_t bucket,
                     const std::vector<HigherBucket>& higher, Effort& effort);

  /// Of the bucket's release at `release`; valid until the next call.
  const Surroundings& of(Duration release);

 private:
  /// Work that was released before the release under examination.
  struct Pending {
    Duration distance;
    Duration cost;
  };

  void find_pending(Duration t);
  void add_start(Duration t0, Duration t);
  bool stays_busy(const Duration* start);

  static constexpr std::int64_t kSteps = 4;  ///< for one release that is looked at

  const TaskSet& set_;
  Duration period_, response_;
  const std::vector<HigherBucket>& higher_;
  Effort& effort_;
  Demand demand_;          ///< all higher-priority demand
  Demand interrupts_;      ///< the streams alone
  Duration longest_busy_;  ///< no higher-priority demand of buckets and streams stays pending for longer
  Surroundings around_;
  std::vector<Pending> pending_;
  std::vector<Duration> starts_;
};

}  // namespace finemote::gen::timing
