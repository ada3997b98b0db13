// Model and profile to what the fixed points work on: interrupt streams, buckets and stage costs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/timing/model.hpp"
#include "generator/timing/raised.hpp"
#include "generator/timing/result.hpp"

namespace finemote::gen::timing {

/// Interrupts of one source in any window of length L: at most ceil(L/separation) and, with budgets, at most
/// sum min(most, count * ceil((ceil((L + jitter)/period) + carry_in) / every)), and those that are raised.
struct Stream {
  struct Budget {
    std::int64_t count = 0;
    Duration period = nanoseconds(1);
    std::int64_t carry_in = 0;
    std::int64_t every = 1;  ///< in this many periods that follow one another
    Duration jitter;         ///< how long before the window what causes them can have been
    std::int64_t most = kUnlimited;
    InterruptCause cause = InterruptCause::clock;
    AskedIn asked_in = AskedIn::handle;
    Rank device;  ///< that causes them, where jobs do
    /// Transfers: of this many more jobs, as in carry_in, because it is not known yet that they end within a period.
    std::int64_t lasting = 0;
    std::size_t kind = 0;  ///< where the stream holds several; all of one have the same separation
    Duration separation;   ///< of two that any budget of the same kind allows; 0: that of the stream
  };
  Duration separation = nanoseconds(1);
  Duration cost;
  std::vector<Budget> budgets;
  std::string name;                    ///< of the bus, with its source where it has several; for people
  std::string bus = {};                ///< the same apart: the bus,
  std::string source = {};             ///< and its source where it has several
  std::optional<BusPlace> place = {};  ///< the bus
  bool of_transfers = false;           ///< only the transfer on the wire of its bus causes them
  bool ends_frame = false;             ///< the end of a frame on the wire of its bus causes them
  std::vector<Raised> raised = {};     ///< by the job in whose window they count (job_streams.hpp)
  /// Nothing but the separation bounds it.
  [[nodiscard]] bool has_budgets() const { return !budgets.empty() || !raised.empty(); }
};

/// The streams in windows in which one job of a bucket runs, from an instant on at which nothing of higher priority
/// waits: beside it only higher-priority jobs run there, those that are released in the window (job_streams.hpp).
struct JobStreams {
  std::vector<Stream> whole;   ///< from before the release to the end of one of its stages
  std::vector<Stream> inside;  ///< from the start of one of its stages to the end of another
};

struct TaskBucket {
  Duration period = nanoseconds(1);
  Duration before;            ///< entry of a job, ahead of the first update
  Duration after;             ///< flush and exit, after the last handle()
  Duration cost;              ///< one whole job
  std::vector<Rank> devices;  ///< registration order
};

/// Streams run above all buckets, shorter periods above longer ones.
struct TaskSet {
  std::vector<Stream> sources;  ///< of buses, one for each of their interrupt sources; of nonzero cost
  std::vector<Stream> dma;      ///< of buses: what theirs takes from the core
  std::vector<Stream> streams;  ///< the same, told apart by what one wire can bring; then of the release interrupt
  std::size_t bus_streams = 0;  ///< how many are of buses
  /// Of every bucket; empty: windows of jobs hold as much as any.
  std::vector<JobStreams> of_jobs;
  /// For every bus and bucket: how long after the release of a job all that it hands over has ended; none: not known.
  Table<BusPlace, std::vector<std::optional<Duration>>> ended;
  std::vector<TaskBucket> buckets;  ///< ascending period
  Table<Rank, std::size_t> bucket_of;
  Table<Rank, std::size_t> place_of;     ///< among the devices of its bucket
  Table<Rank, Duration> update, handle;  ///< one run of the stage with everything around it
  /// How much later than its end an empty stage's data counts as there for a faster consumer in an empty bucket. Under
  /// the rule of the cases not at all: what takes no time at one instant is done in the order of the data. Else one
  /// nanosecond, as the higher-priority bucket may run first (docs/timing.md, "Empty buckets").
  Duration least_lag;
  [[nodiscard]] Duration lag_of_update(Rank producer, Duration consumer_period) const {
    return lag(update[producer], consumer_period);
  }
  [[nodiscard]] Duration lag_of_handle(Rank producer, Duration consumer_period) const {
    return lag(handle[producer], consumer_period);
  }
  Duration blocking;  ///< longest masked section: delays every busy window once
  /// Places of stages in their job (raised.hpp).
  [[nodiscard]] std::size_t update_place(Rank device) const { return place_of[device]; }
  [[nodiscard]] std::size_t handle_place(Rank device) const {
    return flush_place(bucket_of[device]) - 1 - place_of[device];
  }
  [[nodiscard]] std::size_t flush_place(std::size_t bucket) const { return 2 * buckets[bucket].devices.size(); }
  [[nodiscard]] const std::vector<Stream>& in_job(std::size_t bucket) const {
    return of_jobs.empty() ? streams : of_jobs[bucket].whole;
  }
  [[nodiscard]] const std::vector<Stream>& inside_job(std::size_t bucket) const {
    return of_jobs.empty() ? streams : of_jobs[bucket].inside;
  }

 private:
  [[nodiscard]] Duration lag(Duration stage, Duration consumer_period) const;
};

/// Budgets that grow at the same instants become one, whoever causes them: large robots have thousands.
void join_alike(std::vector<Stream::Budget>& budgets);

/// Requires a model that read_model accepts. May throw Overflow.
TaskSet make_task_set(const Model& model, Profile profile);

}  // namespace finemote::gen::timing
