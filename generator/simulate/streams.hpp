// Interrupts of one source: legal arrival sequences, as hostile as its separation and budgets allow.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "generator/simulate/random.hpp"
#include "generator/timing/task_set.hpp"

namespace finemote::gen {

class ArrivalGenerator {
 public:
  ArrivalGenerator(const timing::Stream& stream, Duration largest_period, Random& random)
      : stream_(stream), largest_period_(largest_period), random_(random) {
    next_ = random_.one_in(2) ? Duration::zero() : random_.between({}, largest_period);
    used_.assign(stream.budgets.size(), {kNoPeriod, 0});
    settle();
  }

  [[nodiscard]] Duration next() const { return next_; }

  /// Called when `next()` has arrived; `release` is an instant at which some bucket is released later.
  void advance(Duration release) {
    if (--left_ <= 0) choose();
    const Duration earliest = next_ + stream_.separation;
    switch (manner_) {
      case Manner::fastest:
        next_ = earliest;
        break;
      case Manner::sparse:
        next_ = earliest + random_.between({}, 3 * stream_.separation);
        break;
      case Manner::at_release:
        next_ = std::max(earliest, release), manner_ = Manner::fastest;
        break;
      case Manner::pause:
        next_ = earliest + random_.between({}, largest_period_), manner_ = Manner::fastest;
        break;
    }
    settle();
  }

 private:
  enum class Manner { fastest, sparse, at_release, pause };
  static constexpr std::int64_t kNoPeriod = -1;

  void choose() {
    manner_ = static_cast<Manner>(random_.between(0, 3));
    left_ = random_.between(1, 40);
  }

  /// Moves the next arrival to where some budget still has room, and takes it.
  void settle() {
    if (stream_.budgets.empty()) return;
    for (;;) {
      std::optional<Duration> soonest;
      for (std::size_t i = 0; i < used_.size(); ++i) {
        const timing::Stream::Budget& b = stream_.budgets[i];
        if (b.cause != timing::InterruptCause::clock)
          continue;  // where jobs cause a part of them, that part is left out
        const std::int64_t period = floor_div(next_, b.period);
        const bool is_next = used_[i].period == kNoPeriod || period >= used_[i].period + b.every;
        if (is_next) used_[i] = {period, 0};
        if (used_[i].period == period && used_[i].count < b.count) {
          ++used_[i].count;
          return;
        }
        const Duration later = (used_[i].period + b.every) * b.period;
        if (b.count > 0 && (!soonest || later < *soonest)) soonest = later;
      }
      if (!soonest) {
        next_ = floor_div(Duration::max(), 4);
        return;
      }
      next_ = *soonest;
    }
  }

  struct Used {
    std::int64_t period = kNoPeriod;  ///< the last one with room
    std::int64_t count = 0;
  };

  const timing::Stream& stream_;
  Duration largest_period_;
  Random& random_;
  Duration next_;
  Manner manner_ = Manner::fastest;
  std::int64_t left_ = 8;
  std::vector<Used> used_;
};

}  // namespace finemote::gen
