// Writes numbers into generated code, the same on every system.
#pragma once

#include <string>

namespace finemote::gen {

/// A float literal: 9 significant digits, |x| < 1e-12 is 0, always with a point or exponent and the suffix f.
std::string float_literal(double value);

}  // namespace finemote::gen
