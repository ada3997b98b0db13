// What the timing analysis says of a robot, for the commands that only need the verdict.
#pragma once

#include <optional>
#include <vector>

#include "generator/pipeline.hpp"

namespace finemote::gen {

struct Verdict {
  bool schedulable = false;
  bool requirements_hold = false;
  std::vector<Diagnostic> overloads;  ///< FM4021, of overloaded buses
  Diagnostics reasons;                ///< the findings behind a no, without those; empty after a yes
};

/// None when the analysis gives no answer (an overflow): then the reason is reported.
std::optional<Verdict> verdict_of(const Analysis& analysis, Diagnostics& diagnostics);

}  // namespace finemote::gen
