// Interrupts that the stages of one job raise: a window that ends in the job holds none of the stages behind its end.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "generator/units/duration.hpp"

namespace finemote::gen::timing {

/// As many as there can be.
inline constexpr std::int64_t kUnlimited = std::numeric_limits<std::int64_t>::max();

/// Stages of a job by their places, both included: the updates from 0 on, in the order they run, then the handles, then
/// the flush.
struct Stages {
  std::size_t first = 0, last = std::numeric_limits<std::size_t>::max();
  friend bool operator==(const Stages&, const Stages&) = default;
};

/// Interrupts of one stream that the stages of one job raise at most.
class Raised {
 public:
  /// @param separation  of two of them; 0: that of the stream
  /// @param goes_on     stages before a part of the job raise some in that part, too: transfers last
  /// @param most        of all
  Raised(Duration separation, bool goes_on, std::int64_t most = kUnlimited)
      : separation_(separation), goes_on_(goes_on), most_(most) {}

  /// A stage raises so many. Places must not fall.
  void add(std::size_t place, std::int64_t count) { stages_.push_back({place, sum_up_to(place) + count}); }

  /// Those that can come while these stages run.
  [[nodiscard]] std::int64_t in(const Stages& stages) const {
    const std::int64_t before = goes_on_ || stages.first == 0 ? 0 : sum_up_to(stages.first - 1);
    return std::min(most_, sum_up_to(stages.last) - before);
  }

  [[nodiscard]] Duration separation() const { return separation_; }

 private:
  struct Stage {
    std::size_t place;
    std::int64_t sum;  ///< of this stage and those before
  };

  [[nodiscard]] std::int64_t sum_up_to(std::size_t place) const {
    const auto behind = std::upper_bound(stages_.begin(), stages_.end(), place,
                                         [](std::size_t p, const Stage& stage) { return p < stage.place; });
    return behind == stages_.begin() ? 0 : (behind - 1)->sum;
  }

  Duration separation_;
  bool goes_on_;
  std::int64_t most_;
  std::vector<Stage> stages_;  ///< rising places
};

}  // namespace finemote::gen::timing
