// Turns the times at which a control law runs into the step that it integrates over.
#pragma once

#include "finemote/control/numbers.hpp"
#include "finemote/time.hpp"

namespace finemote {

/// From one step of a control law to the next.
class StepTime {
 public:
  static constexpr float kLongest = 0.1F;  ///< s; a law does not integrate over a longer gap

  /// Seconds since the last call; 0 where they are more than kLongest. Context: bucket.
  float next(Time at) {
    const float elapsed = seconds(at - last_);
    last_ = at;
    return elapsed <= kLongest ? elapsed : 0;
  }

 private:
  Time last_ = 0;
};

}  // namespace finemote
