// Counts the steps an analysis takes, so that no model can make it run for hours.
#pragma once

#include <cstdint>
#include <stdexcept>

namespace finemote::gen::timing {

/// The analysis would take longer than its budget of steps; becomes FM4011.
struct TooLong : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Some seconds of work.
inline constexpr std::int64_t kMostSteps = std::int64_t{1} << 31;

/// What is left of a budget of steps. One step is one evaluation of one term.
class Effort {
 public:
  explicit Effort(std::int64_t steps = kMostSteps) : left_(steps) {}
  /// Throws TooLong.
  void spend(std::int64_t steps) {
    if ((left_ -= steps) < 0) throw TooLong("the response times need more steps than the analysis allows");
  }

 private:
  std::int64_t left_;
};

}  // namespace finemote::gen::timing
