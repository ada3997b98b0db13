// Python's built-in functions, as far as xacro exposes them, and the types that can be called.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

class Runtime;

using Symbols = std::vector<std::pair<std::string, Value>>;

/// What every expression sees: list dict map len str float int min max round True False, all of math, and with a
/// deprecation warning sorted range load_yaml abs_filename dotify.
Symbols global_symbols();
/// What `python.` holds.
Symbols python_symbols();
/// What `math.` holds.
Symbols math_symbols();
/// What `xacro.` holds.
Symbols xacro_symbols();
/// The functions of `xacro.` that are global as well, for old files.
Symbols deprecated_xacro_symbols();

/// Calls a type: int('3'), list(x), dict(a=1) ...
Value construct(Runtime& runtime, Type type, CallArguments& arguments);

/// The entries that dict() and update() take: a mapping or pairs, and keywords.
std::shared_ptr<Table> table_of(Runtime& runtime, const CallArguments& arguments, std::string_view function);

/// The items in order; takes the keywords `key` and `reverse`.
Values sorted_items(Runtime& runtime, Values items, CallArguments& arguments, std::string_view function);

}  // namespace finemote::gen::expression
