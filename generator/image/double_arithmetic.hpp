// Routines of the compiler's library by which a core without double precision calculates with `double`.
#pragma once

#include <string_view>

namespace finemote::gen {

/// Run-time ABI for the Arm architecture (IHI 0043), 4.1.2.
constexpr bool is_double_arithmetic(std::string_view function) { return function.substr(0, 9) == "__aeabi_d"; }

/// The same manual: `float` to 64 bits, which goes through `double`.
constexpr bool is_float_to_64_bits(std::string_view function) {
  return function == "__aeabi_f2lz" || function == "__aeabi_f2ulz" || function == "__fixsfdi" ||
         function == "__fixunssfdi";
}

/// What somebody can do who calls one: there is no bound for it, of its time nor of its stack.
inline constexpr std::string_view kInsteadOfDouble = "use 'float', and write constants as 0.5F";
inline constexpr std::string_view kInsteadOf64Bits = "make a 32-bit integer of it first";

}  // namespace finemote::gen
