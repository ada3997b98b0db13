// The findings of lint: one table, from which the command line knows what can be allowed and denied.
#pragma once

#include <algorithm>
#include <array>

#include "generator/diagnostic/code.hpp"
#include "generator/diagnostic/code_hardware.hpp"
#include "generator/diagnostic/code_mechanics.hpp"

namespace finemote::gen {

/// Each can be allowed and denied.
inline constexpr std::array kLintCodes{
    code::lint_order,         code::lint_period_ratio,   code::lint_no_wcet,        code::lint_conversion,
    code::lint_bus_load,      code::lint_unused_bus,     code::lint_param_replaced, code::lint_wrench_axis,
    code::lint_wrench_effort, code::lint_out_of_reach,   code::lint_command_age,    code::lint_sensor_place,
    code::lint_wheel_limits,  code::lint_moved_joint,    code::lint_no_mass,        code::lint_same_place,
    code::lint_param_range,   code::timing_bus_overload, code::lint_odd_output};

constexpr bool is_lint_code(Code code) {
  return std::find(kLintCodes.begin(), kLintCodes.end(), code) != kLintCodes.end();
}

/// A code of the table: lint reports with these alone, so a finding that nobody can allow does not compile.
struct LintCode {
  Code code;
  consteval LintCode(Code listed) : code(listed) {  // NOLINT(google-explicit-constructor)
    if (!is_lint_code(listed)) throw "add the code to kLintCodes";
  }
};

}  // namespace finemote::gen
