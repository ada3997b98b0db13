// What may be built into a robot's firmware, or assumed of it, beside what its description says.
#pragma once

#include <optional>

#include "generator/units/duration.hpp"

namespace finemote::gen::timing {

struct RobotTimingOptions {
  bool trace = false;                    ///< the trace option is on: every stage records two events
  bool monitor = false;                  ///< the monitor option is on: every handle and every job is looked at
  std::optional<Duration> assumed_wcet;  ///< instead of every assumed execution time (`--assume-wcet`)
};

}  // namespace finemote::gen::timing
