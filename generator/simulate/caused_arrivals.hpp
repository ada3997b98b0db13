// Interrupts of one source that jobs cause: legal arrival sequences, as hostile as its budgets allow.
#pragma once

#include <deque>
#include <vector>

#include "generator/simulate/random.hpp"
#include "generator/timing/task_set.hpp"

namespace finemote::gen {

/// Requests come at once when a stage asks, where it begins or ends, or a flush begins; transfers until what was asked
/// for has ended, or until the next release where it is unknown when that is; of a line, a number of them from one look
/// to the next.
class CausedArrivals {
 public:
  /// Everything must outlive this.
  CausedArrivals(const timing::Stream& stream, const timing::TaskSet& set, Random& random);

  /// Whether jobs cause all interrupts of a stream.
  static bool cause(const timing::Stream& stream);

  /// The next arrival; far away where nothing has asked for one.
  [[nodiscard]] Duration next() const;
  /// Called when `next()` has arrived; releases are nothing to it.
  void advance(Duration) { planned_.pop_front(); }

  /// A stage of the job released at `release` begins now.
  void stage_began(Rank device, bool is_update, Duration release, Duration now);
  /// It has ended now.
  void stage_ended(Rank device, bool is_update, Duration release, Duration now);
  /// All handles of the bucket's job released at `release` have ended now.
  void flush_began(std::size_t bucket, Duration release, Duration now);

 private:
  static bool asks(const timing::Stream::Budget& budget, Rank device, bool is_update);
  enum class AtEnd { nothing, asks, asks_again };
  /// Whether it is the turn of this job.
  bool raise(std::size_t budget, Duration release, Duration now);
  [[nodiscard]] Duration begin_of(const timing::Stream::Budget& budget, Duration now, Duration latest);
  void ask(const timing::Stream::Budget& budget, Duration from, Duration latest);
  [[nodiscard]] Duration latest_end(const timing::Stream::Budget& budget, Duration release, Duration now) const;

  const timing::Stream& stream_;
  const timing::TaskSet& set_;
  Random& random_;
  std::deque<Duration> planned_;         ///< rising
  Duration free_from_;                   ///< the separation from the one planned last
  std::vector<std::int64_t> jobs_left_;  ///< per budget: before one may ask again
  std::vector<AtEnd> at_end_;            ///< per budget: what the stage that runs does when it ends
};

}  // namespace finemote::gen
