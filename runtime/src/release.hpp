// Turns periods into releases: which buckets are due at the next instant, and how long until the one after it.
#pragma once

#include <cstdint>

#include "finemote/schedule.hpp"

namespace finemote::detail {

/// One instant at which something is released.
struct Release {
  std::uint32_t due = 0;    ///< the set of buckets due at this instant; 0 for a stop on a long way
  std::uint32_t ticks = 0;  ///< from this instant to the next, >= 1
};

/// A period in ticks.
struct Ticks {
  std::uint32_t count;  ///< whole ticks, sticks at 2^32 - 1
  bool exact;           ///< no part of a tick is left over
};
/// Long division, bit by bit: the library's 64-bit division would cost an image 800 bytes for a use at start.
Ticks ticks_in(Duration period, std::uint32_t tick_ns);

/// Counts every bucket down in ticks, in its BucketState. The first instant releases all buckets.
class ReleasePlan {
 public:
  constexpr ReleasePlan() = default;

  /// The bits of the states are set already. Instants are at most `longest_step` ticks apart.
  void start(const Schedule& schedule, std::uint32_t longest_step);

  /// The next instant: one short pass over the buckets. `schedule` is that of the start.
  Release next(const Schedule& schedule);

 private:
  std::uint32_t step_ = 0;
  std::uint32_t longest_step_ = 0;
};

/// The watchdog's rule: which buckets complete no jobs any more.
///
/// A bucket that is neither pending nor running when it is released has completed every job before; one that is found
/// so (late) is not released again, so being late `watchdog` times in a row is that many periods without a completed
/// job.
class StarvationWatch {
 public:
  constexpr StarvationWatch() = default;

  /// Takes note of one instant; `due` and `late` are sets of buckets. May be left out while nothing is late and
  /// quiet().
  void note(const Schedule& schedule, std::uint32_t due, std::uint32_t late);

  /// True while every bucket was on time when last released.
  [[nodiscard]] bool quiet() const { return late_ == 0; }
  /// True while some bucket completes no jobs: the watchdog must not be fed.
  [[nodiscard]] bool starving() const { return starving_ != 0; }

 private:
  std::uint32_t late_ = 0;
  std::uint32_t starving_ = 0;
};

/// Counts an overrun of every bucket of this set and calls the hook. Does not return when the schedule says safe_stop.
void report_overruns(std::uint32_t late);

}  // namespace finemote::detail
