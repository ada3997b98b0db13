// All rules of lint: the table from which the command line and the documents know them.
#pragma once

#include <span>
#include <vector>

#include "generator/lint/rule.hpp"

namespace finemote::gen {

/// In the order in which findings at one place are reported.
std::span<const Rule> lint_rules();

/// In the order in which users look for them.
std::vector<Rule> lint_rules_by_number();

/// Whether a rule has this number: it can be allowed and denied.
bool is_lint_code(Code code);

}  // namespace finemote::gen
