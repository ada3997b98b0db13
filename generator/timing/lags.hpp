// How long after its release a slower producer's data is there for sure, per release.
#pragma once

#include "generator/timing/releases.hpp"

namespace finemote::gen::timing {

/// In whole multiples of the common divisor of the periods of producer and consumer: releases of both only differ by
/// such.
struct Lags {
  Duration most;                  ///< of all rows of the producer's release table; 0: at once, as it is not slower
  std::vector<Duration> per_row;  ///< empty: `most` in every row
  friend auto operator<=>(const Lags&, const Lags&) = default;
};

/// What handle() of a producer hands down to a faster consumer, from the producer's R-(t). When the steps are spent,
/// `most` counts in every row.
Lags lags_down(const TaskSet& set, const ReleaseTable& table, Rank producer, Duration consumer_period, Effort& effort);

/// What update() of a producer hands up to a faster consumer, from the producer's R+(t); else the same.
Lags lags_up(const TaskSet& set, const ReleaseTable& table, Rank producer, Duration consumer_period, Effort& effort);

/// The lag at one release after the other: mostly the same release, or the one after it.
class LagCursor {
 public:
  /// @param period  of the producer. Lags and table outlive the cursor.
  LagCursor(const Lags& lags, const ReleaseTable& table, Rank producer, Duration period)
      : lags_(lags), table_(table), producer_(producer), period_(period), lag_(lags.most) {}

  Duration at(Duration release) {
    if (!lags_.per_row.empty() && release != release_) move_to(release);
    return lag_;
  }

 private:
  void move_to(Duration release) {
    if (release - release_ == period_ && release_ != kNone) {
      if (++turn_ == table_.turns(producer_)) turn_ = 0;
    } else {
      turn_ = table_.turn(producer_, release);
    }
    release_ = release;
    lag_ = lags_.per_row[table_.row_of_turn(producer_, turn_)];
  }

  const Lags& lags_;
  const ReleaseTable& table_;
  Rank producer_;
  Duration period_;
  Duration release_ = kNone;
  std::size_t turn_ = 0;
  Duration lag_;
};

}  // namespace finemote::gen::timing
