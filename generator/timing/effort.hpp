// What exactness may cost: where it would cost more, a closed form that is never smaller stands in (docs/timing.md).
#pragma once

#include <cstdint>

namespace finemote::gen::timing {

/// Up to where the analysis of one profile is exact.
struct Limits {
  /// Releases that are examined one by one: those of every bucket until it and all higher-priority ones repeat,
  /// together.
  std::int64_t releases = 1'000'000;
  /// Of a model that has more: of one bucket, and of the root of one path, that are examined all the same.
  std::int64_t releases_alone = 1'000;
  /// One is about the evaluation of one term, some nanoseconds. Half of them are for the searches of response times.
  std::int64_t steps = std::int64_t{1} << 26;
};

/// Of one among many models that are tried, an order of devices or a factor of their times; an ordinary robot needs
/// some thousands.
inline constexpr Limits kTrialLimits{.steps = std::int64_t{1} << 22};

/// What is left of the limits of one analysis.
class Effort {
 public:
  explicit Effort(const Limits& limits = {}) : Effort(limits.steps, limits.releases) {}
  /// @param most_releases  of one bucket, and of the root of one path
  Effort(std::int64_t steps, std::int64_t most_releases) : left_(steps), most_releases_(most_releases) {}

  /// Whether there were that many steps left. Once there were not, there are none at all.
  bool spend(std::int64_t steps) {  // its answer may be left aside where is_spent() is asked later
    left_ = steps > left_ ? -1 : left_ - steps;
    return left_ >= 0;
  }
  [[nodiscard]] bool is_spent() const { return left_ < 0; }
  [[nodiscard]] std::int64_t most_releases() const { return most_releases_; }

 private:
  std::int64_t left_;
  std::int64_t most_releases_;
};

}  // namespace finemote::gen::timing
