// Model and profile to what the fixed points work on: interrupt streams, buckets and stage costs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/timing/model.hpp"
#include "generator/timing/result.hpp"

namespace finemote::gen::timing {

/// Interrupts of one source in any window of length L: at most ceil(L/separation) and, with budgets, at most
/// sum count * ceil((ceil(L/period) + carry_in) / every).
struct Stream {
  struct Budget {
    std::int64_t count = 0;
    Duration period = nanoseconds(1);
    std::int64_t carry_in = 0;
    std::int64_t every = 1;  ///< in so many periods that follow one another
  };
  Duration separation = nanoseconds(1);
  Duration cost;
  std::vector<Budget> budgets;
  std::string name;                           ///< of the bus, with its source where it has several; for people
  std::string bus = {};                       ///< the same apart: the bus,
  std::string source = {};                    ///< and its source where it has several
  std::optional<BusPlace> of_transfers = {};  ///< the bus, where only the transfer on its wire causes them
};

struct TaskBucket {
  Duration period = nanoseconds(1);
  Duration before;            ///< entry of a job, ahead of the first update
  Duration after;             ///< flush and exit, behind the last handle
  Duration cost;              ///< one whole job
  std::vector<Rank> devices;  ///< registration order
};

/// Streams run above all buckets, shorter periods above longer ones.
struct TaskSet {
  std::vector<Stream> streams;      ///< of nonzero cost: those of buses first, then of the release interrupt
  std::size_t bus_streams = 0;      ///< how many are of buses
  std::vector<TaskBucket> buckets;  ///< ascending period
  Table<Rank, std::size_t> bucket_of;
  Table<Rank, Duration> update, handle;  ///< one run of the stage with everything around it
  /// How much later than its end an empty stage's data counts as there for a faster consumer in an empty bucket. Under
  /// the rule of the cases not at all: what takes no time at one instant is done in the order of the data. Else one
  /// nanosecond, as the more urgent bucket may run first (docs/timing.md, "Empty buckets").
  Duration least_lag;
  [[nodiscard]] Duration lag_of_update(Rank producer, Duration consumer_period) const {
    return lag(update[producer], consumer_period);
  }
  [[nodiscard]] Duration lag_of_handle(Rank producer, Duration consumer_period) const {
    return lag(handle[producer], consumer_period);
  }
  Duration blocking;  ///< longest masked section: delays every busy window once

 private:
  [[nodiscard]] Duration lag(Duration stage, Duration consumer_period) const;
};

/// Requires a model that read_model accepts. May throw Overflow.
TaskSet make_task_set(const Model& model, Profile profile);

}  // namespace finemote::gen::timing
