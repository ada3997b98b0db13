// The jobs of the buckets while a simulation runs: when they are released, and which piece of work each has come to.
#pragma once

#include <optional>
#include <vector>

#include "generator/simulate/simulate.hpp"
#include "generator/timing/task_set.hpp"

namespace finemote::gen {

/// The job of one bucket: entry, updates forward, handles backward, flush.
struct JobState {
  bool active = false;
  Duration release;
  Duration begin = kNothing;
  std::size_t piece = 0;  ///< 0 entry, 1..n updates, n+1..2n handles, 2n+1 flush
  bool piece_begun = false;
  Duration piece_begin;
  Duration left;
  std::optional<Duration> next;  ///< the next release, which found the job unfinished

  void start(Duration at);

  /// A release of the bucket. Returns how many releases are skipped by it: one can wait.
  std::int64_t released(Duration at);

  /// The job ends; how many jobs it spoils: itself when it is late, and the one that waits. It may end at the very
  /// release of the next one, as stages of zero length still have to be dispatched there.
  std::int64_t end(Duration now, Duration period);
};

/// What the pieces of a bucket's job are.
class Pieces {
 public:
  /// `bucket` outlives this.
  Pieces(const timing::TaskSet& set, const timing::TaskBucket& bucket);

  [[nodiscard]] bool is_entry(std::size_t piece) const { return piece == 0; }
  [[nodiscard]] bool is_update(std::size_t piece) const { return piece >= 1 && piece <= count(); }
  [[nodiscard]] bool is_handle(std::size_t piece) const { return piece > count() && piece <= 2 * count(); }
  [[nodiscard]] bool is_flush(std::size_t piece) const { return piece > 2 * count(); }
  /// Of an update or a handle.
  [[nodiscard]] Rank device(std::size_t piece) const {
    return bucket_.devices[piece <= count() ? piece - 1 : 2 * count() - piece];
  }
  [[nodiscard]] bool is_last(std::size_t piece) const { return piece + 1 == worst_.size(); }
  /// The longest a piece can take.
  [[nodiscard]] Duration worst(std::size_t piece) const { return worst_[piece]; }
  /// Whether all pieces from this one on take no time.
  [[nodiscard]] bool take_no_time_from(std::size_t piece) const { return piece >= untimed_from_; }

 private:
  [[nodiscard]] std::size_t count() const { return bucket_.devices.size(); }

  const timing::TaskBucket& bucket_;
  std::vector<Duration> worst_;
  std::size_t untimed_from_ = 0;
};

/// Which job goes on first among those with a piece that takes no time, ahead of work that takes some: what empties at
/// one instant does so in the order of the data. What was released before goes first, then updates, children before
/// their parents, then handles, parents before their children. None where more urgent work keeps all of them waiting.
std::optional<std::size_t> next_without_time(const std::vector<JobState>& jobs, const std::vector<Pieces>& pieces,
                                             Duration now);

/// When buckets are released: each once per period, from time 0 on.
class ReleaseClock {
 public:
  /// What is released together.
  struct Due {
    std::vector<std::size_t> buckets;
    Duration released;  ///< when the last of them was due
  };

  explicit ReleaseClock(const std::vector<timing::TaskBucket>& buckets) : buckets_(buckets), next_(buckets.size()) {}

  /// The next release of all.
  [[nodiscard]] Duration next() const;
  [[nodiscard]] Duration next_of(std::size_t bucket) const { return next_[bucket]; }

  /// Everything that is due at `now`.
  Due take(Duration now);

 private:
  const std::vector<timing::TaskBucket>& buckets_;
  std::vector<Duration> next_;
};

}  // namespace finemote::gen
