// Floats to texts of a given precision, exactly as C and Python round them, whatever the locale.
#pragma once

#include <string>

namespace finemote::gen::expression {

/// The digits of |value| as %e, %f or %g print them ('e', 'f', 'g'; capitals for capitals); inf and nan as words.
/// `alternate` keeps the point and the zeros that %g would drop.
std::string format_magnitude(double value, char type, int precision, bool alternate);

/// Python's round(value, digits): ties to even of the exact value.
double round_to(double value, long digits);

}  // namespace finemote::gen::expression
