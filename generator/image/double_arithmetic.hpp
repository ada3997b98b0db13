// Routines of the compiler's library by which a core without double precision calculates with `double`.
#pragma once

#include <string_view>

namespace finemote::gen {

/// Run-time ABI for the Arm architecture (IHI 0043), 4.1.2.
constexpr bool is_double_arithmetic(std::string_view function) { return function.substr(0, 9) == "__aeabi_d"; }

/// What somebody can do who calls one: there is no bound for it, of its time nor of its stack.
inline constexpr std::string_view kInsteadOfDouble = "use 'float', and write constants as 0.5F";

}  // namespace finemote::gen
