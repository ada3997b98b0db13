// A correct robot to warnings that save robots, and to the edits that mend the mechanical ones.
#pragma once

#include <optional>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/lint/rule.hpp"

namespace finemote::gen {

struct LintOptions {
  std::vector<Code> allow;  ///< not reported
  std::vector<Code> deny;   ///< reported as errors
  double most_bus_load = 0.7;
  Table<BusId, double> bus_load;                            ///< 0..1, from the timing analysis; empty: not known
  Table<DeviceId, std::optional<CommandAge>> command_ages;  ///< proven; empty: not known
  std::vector<Diagnostic> overloads;  ///< FM4021 of the timing analysis, instead of FM3155 for these buses; who denies
                                      ///< FM3155 denies them
};

/// Looks for what is valid and yet rarely meant: reports what the rules of lint_rules() find, bus by bus and device by
/// device.
/// @return  one for each finding that an edit could mend
std::vector<Fix> lint(const Robot& robot, const LintOptions& options, Diagnostics& diagnostics);

}  // namespace finemote::gen
