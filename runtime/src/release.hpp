// Turns periods into releases: which buckets are due at the next instant, and how long until the one after it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/schedule.hpp"

namespace finemote::detail {

/// One instant at which something is released.
struct Release {
  std::uint32_t due = 0;    ///< bits of the buckets due at this instant; 0 for a stop on a long way
  std::uint32_t ticks = 0;  ///< from this instant to the next, >= 1
};

/// A period in ticks.
struct Ticks {
  std::uint32_t count;  ///< whole ticks, sticks at 2^32 - 1
  bool exact;           ///< no part of a tick is left over
};
/// Long division, bit by bit: the library's 64-bit division would cost an image 800 bytes for a use at start.
Ticks ticks_in(Duration period, std::uint32_t tick_ns);

/// Counts every bucket down in ticks. The first instant releases all buckets.
class ReleasePlan {
 public:
  constexpr ReleasePlan() = default;

  /// `bits[i]` stands for bucket i in Release::due. Instants are at most `longest_step` ticks apart.
  void start(const Schedule& schedule, const std::uint32_t* bits, std::uint32_t longest_step);

  /// The next instant: one short pass over the buckets, of which there are as many as at the start.
  Release next(std::size_t buckets);

 private:
  struct Entry {
    std::uint32_t left;
    std::uint32_t period;
    std::uint32_t bit;
  };

  Entry entries_[kMaxBuckets]{};
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

  /// Takes note of one instant; `bits` as in ReleasePlan::start. May be left out while nothing is late and quiet().
  void note(const Schedule& schedule, const std::uint32_t* bits, std::uint32_t due, std::uint32_t late);

  /// True while every bucket was on time when last released.
  [[nodiscard]] bool quiet() const { return late_ == 0; }
  /// True while some bucket completes no jobs: the watchdog must not be fed.
  [[nodiscard]] bool starving() const { return starving_ != 0; }

 private:
  std::uint8_t missed_[kMaxBuckets]{};
  std::uint32_t late_ = 0;
  std::uint32_t starving_ = 0;
};

/// Counts an overrun of every bucket in `late` (bits as given to ReleasePlan::start) and calls the hook.
/// Does not return when the schedule says safe_stop.
void report_overruns(std::uint32_t late, const std::uint32_t* bits);

}  // namespace finemote::detail
