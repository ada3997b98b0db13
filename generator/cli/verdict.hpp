// What the timing analysis says of a robot, for the commands that only need the verdict.
#pragma once

#include <optional>

#include "generator/cli/load.hpp"
#include "generator/lint/lint.hpp"
#include "generator/timing/analyse.hpp"

namespace finemote::gen {

struct Verdict {
  bool schedulable = false;
  bool requirements_hold = false;
  Table<BusId, double> bus_load;                            ///< 0..1; empty when there is no answer
  Table<DeviceId, std::optional<CommandAge>> command_ages;  ///< none where there is no bound
  std::vector<Diagnostic> overloads;                        ///< FM4021, of overloaded buses
  Diagnostics reasons;  ///< the findings behind a no, without those; empty after a yes
};

/// Only lint looks at the ages of commands, and they take as long as the rest of the analysis.
enum class CommandAges { needed, left_out };

/// Analyses the robot in its default profile. None when the analysis gives no answer (an overflow); then the reason is
/// in the context's diagnostics.
std::optional<Verdict> timing_verdict(Context& context, const Loaded& loaded, CommandAges ages);

}  // namespace finemote::gen
