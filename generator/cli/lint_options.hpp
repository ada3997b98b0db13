// What lint is told, from the command line and the timing analysis; shared by `lint` and `check`.
#pragma once

#include "generator/cli/verdict.hpp"
#include "generator/lint/lint.hpp"

namespace finemote::gen {

/// Reports FM0001 for words of --allow and --deny that are no code.
LintOptions lint_options(Context& context, const Verdict& verdict);

}  // namespace finemote::gen
