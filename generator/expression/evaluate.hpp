// Expressions to values.
#pragma once

#include "generator/expression/expression.hpp"
#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

class Runtime;

/// The value of an expression with the names visible in `scope`. Fails as Python would, in its words.
Value evaluate(Runtime& runtime, const Expression& expression, Scope& scope);

/// function(arguments) for library functions, methods, types and lambdas.
Value call_value(Runtime& runtime, const Value& function, CallArguments& arguments);

}  // namespace finemote::gen::expression
