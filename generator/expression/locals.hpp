// The names that comprehensions and lambdas bind.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "generator/expression/expression.hpp"
#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

/// One level of names, inside others.
struct Locals {
  std::vector<std::pair<std::string, Value>> names;
  std::shared_ptr<Locals> outer;
};
using LocalsPtr = std::shared_ptr<Locals>;

/// The innermost value of that name, or null.
const Value* find_local(const Locals* locals, const std::string& name);

/// Gives a name a value, or each name of a tuple or list of targets its part; fails when their numbers differ.
void bind(Runtime& runtime, Locals& locals, const Expression& target, const Value& value);

/// The arguments of a lambda call bound to its parameters; fails with Python's words when they do not fit.
LocalsPtr bind_parameters(const Lambda& function, CallArguments& arguments);

}  // namespace finemote::gen::expression
