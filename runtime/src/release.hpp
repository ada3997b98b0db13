// Turns periods into releases: which buckets are due at the next instant, and how long until the one after it.
#pragma once

#include <cstdint>

#include "finemote/schedule.hpp"

namespace finemote::detail {

/// One instant at which something is released.
struct Release {
  std::uint32_t due = 0;    ///< bits of the buckets due at this instant; 0 for a stop on a long way
  std::uint32_t ticks = 0;  ///< from this instant to the next, >= 1
};

/// Counts every bucket down in ticks. The first instant releases all buckets.
/// The cost of one next() is one short pass over the buckets; the release interrupt calls it once.
class ReleasePlan {
 public:
  constexpr ReleasePlan() = default;

  /// `bits[i]` stands for bucket i in Release::due. Instants are at most `longest_step` ticks apart.
  void start(const Schedule& schedule, const std::uint32_t* bits, std::uint32_t longest_step);

  /// The next instant; also takes stock of which buckets have completed a job since they were last planned.
  Release next() {
    Release release;
    std::uint32_t nearest = longest_step_;
    for (Entry* entry = entries_; entry < end_; ++entry) {
      entry->left -= step_;
      if (entry->left == 0) {
        entry->left = entry->period;
        release.due |= entry->bit;
        watch(*entry);
      }
      if (entry->left < nearest) nearest = entry->left;
    }
    step_ = nearest;
    release.ticks = nearest;
    return release;
  }

  /// True while some bucket has not completed a job for its `watchdog` number of periods: the watchdog must starve too.
  [[nodiscard]] bool starving() const { return starving_ != 0; }

 private:
  struct Entry {
    std::uint32_t left;
    std::uint32_t period;
    std::uint32_t bit;
    volatile std::uint8_t* completed;
    std::int16_t missed;
    std::int16_t limit;
  };

  void watch(Entry& entry) {
    if (*entry.completed != 0) {
      *entry.completed = 0;
      if (entry.missed != 0) recover(entry);
    } else {
      miss(entry);
    }
  }
  void recover(Entry& entry);
  void miss(Entry& entry);

  Entry entries_[kMaxBuckets]{};
  Entry* end_ = nullptr;
  std::uint32_t step_ = 0;
  std::uint32_t longest_step_ = 0;
  std::uint32_t starving_ = 0;
};

/// Counts an overrun of every bucket in `late` (bits as given to ReleasePlan::start) and calls the hook.
/// Does not return when the schedule says safe_stop.
void report_overruns(std::uint32_t late, const std::uint32_t* bits);

}  // namespace finemote::detail
