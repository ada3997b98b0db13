// Fixes that lint proposes to those that do what they say and nothing else.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "generator/cli/options.hpp"
#include "generator/cli/verdict.hpp"
#include "generator/lint/lint.hpp"
#include "generator/pipeline.hpp"

namespace finemote::gen {

/// A robot as lint sees it, with all that was said of it.
struct Linted {
  PlannedRobot planned;
  Verdict verdict;
  LintOptions options;
  Diagnostics findings;  ///< of lint
  std::vector<Fix> fixes;
};

/// The robot after its text was edited, and whatever its positions point into.
struct Edited {
  std::string text;
  Sources sources;
  Diagnostics diagnostics;
  std::optional<Linted> linted;
};

struct AppliedFixes {
  std::unique_ptr<Edited> edited;  ///< null when nothing was fixed
  std::vector<const Fix*> fixed;
  std::vector<std::pair<const Fix*, std::string>> refused;  ///< with the reason
};

/// Analyses and lints a robot, with --allow and --deny; none after an error.
std::optional<Linted> lint_planned(const Options& options, PlannedRobot planned, Diagnostics& diagnostics);

/// Tries the fixes on the text of `input` in memory. One is taken if the edited text, read with the same arguments, has
/// neither errors nor findings that were not there before, lacks the finding, and is the same robot but for the order
/// of devices, or the bus that is removed. Writes nothing.
/// @param said  the findings of reading and planning the robot
AppliedFixes apply_fixes(const Options& options, const Input& input, const Linted& linted, const Sources& sources,
                         const Diagnostics& said);

}  // namespace finemote::gen
