// Expressions to values.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "generator/expression/expression.hpp"
#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

class Runtime;

/// The names that comprehensions and lambdas bind, innermost first.
struct Locals {
  std::vector<std::pair<std::string, Value>> names;
  std::shared_ptr<Locals> outer;
};

/// The value of an expression with the names visible in `scope`. Fails as Python would, in its words.
Value evaluate(Runtime& runtime, const Expression& expression, Scope& scope);

/// function(arguments) for library functions, methods, types and lambdas.
Value call_value(Runtime& runtime, const Value& function, CallArguments& arguments);

}  // namespace finemote::gen::expression
