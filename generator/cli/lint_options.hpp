// What lint is told, from the command line and the timing analysis; shared by `lint` and `check`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/cli/verdict.hpp"
#include "generator/lint/lint.hpp"
#include "generator/pipeline.hpp"

namespace finemote::gen {

/// `allow`, `deny`: words of these options. Reports FM0001 for those that are no code of lint; none after an error.
std::optional<LintOptions> lint_options(const std::vector<std::string>& allow, const std::vector<std::string>& deny,
                                        const PlannedRobot& planned, const timing::Timing& timing,
                                        const Verdict& verdict, Diagnostics& diagnostics);

}  // namespace finemote::gen
