// Interrupts that the stages of one job raise: a window that ends in the job holds none of the stages after its end.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "generator/timing/unlimited.hpp"
#include "generator/units/checked.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen::timing {

/// Stages of a job by their places, both included: the updates from 0 on, in the order they run, then the handles, then
/// the flush.
struct Stages {
  std::size_t first = 0, last = std::numeric_limits<std::size_t>::max();
};

/// Interrupts of one kind and stream that the stages of one job raise at most.
class Raised {
 public:
  struct Kind {
    std::size_t number = 0;  ///< of those that one stream holds
    Duration separation;     ///< of two of them; 0: that of the stream
    bool goes_on = false;    ///< stages before a part of the job raise some in that part, too: transfers last
    std::int64_t most = kUnlimited;
    friend auto operator<=>(const Kind&, const Kind&) = default;
  };

  explicit Raised(const Kind& kind) : kind_(kind) {}

  /// A stage raises `count` of them. Places must not fall. Throws Overflow.
  void add(std::size_t place, std::int64_t count) { stages_.push_back({place, gen::add(sum_up_to(place), count)}); }

  /// Those that can come while these stages run.
  [[nodiscard]] std::int64_t in(const Stages& stages) const {
    const std::int64_t before = kind_.goes_on || stages.first == 0 ? 0 : sum_up_to(stages.first - 1);
    return std::min(kind_.most, sum_up_to(stages.last) - before);
  }

  [[nodiscard]] Duration separation() const { return kind_.separation; }

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

  Kind kind_;
  std::vector<Stage> stages_;  ///< rising places
};

}  // namespace finemote::gen::timing
