// Writes numbers into generated code, the same on every system.
#pragma once

#include <stdexcept>
#include <string>

namespace finemote::gen {

/// A number that has no literal: infinite, no number, or beyond the range of a float.
class NoFloat : public std::domain_error {
 public:
  explicit NoFloat(double value);
};

/// A float literal: 9 significant digits, |x| < 1e-12 is 0, always with a point or exponent and the suffix f. Throws
/// NoFloat rather than write text that compiles to something else, or not at all.
std::string float_literal(double value);

/// The same of a number that a person wrote: a small one is no rounding error, and stays.
std::string given_float_literal(double value);

}  // namespace finemote::gen
