// The operators of the expression language on values.
#pragma once

#include "generator/expression/expression.hpp"
#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

class Runtime;

/// a + b and the like; fails with "unsupported operand type(s) for +: 'int' and 'str'".
Value operate(Runtime& runtime, Operator op, const Value& a, const Value& b);

/// -a, +a, ~a, not a.
Value operate(Runtime& runtime, Operator op, const Value& a);

/// a < b, a in b, a is b ...
bool compare(Runtime& runtime, Operator op, const Value& a, const Value& b);

/// Python's pow for numbers: an int to a negative int is a float.
Value raise_to(const Value& base, const Value& exponent);

}  // namespace finemote::gen::expression
