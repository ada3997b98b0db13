// Values to text, as Python prints them.
#pragma once

#include <string>

#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

class Runtime;

/// Python's str(value): a text as it is, True, 1.0, [1, 'x'].
std::string to_text(Runtime& runtime, const Value& value);

/// Python's repr(value): as to_text, but texts are quoted.
std::string to_source(Runtime& runtime, const Value& value);

/// The shortest decimal that reads back the same: 0.1, 1.0, 1e-05, 1e+16, inf, nan.
std::string real_to_text(double value);

}  // namespace finemote::gen::expression
