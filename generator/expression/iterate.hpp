// What a loop over a value meets.
#pragma once

#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

class Runtime;

/// The items of a list, tuple, text (its characters), dict (its keys), set, range or iterator (which it empties);
/// fails with "'int' object is not iterable" for others.
Values items_of(Runtime& runtime, const Value& value);

/// Python's len(); fails for values without.
std::size_t size_of(const Value& value);

/// Python's `item in container`.
bool contains(Runtime& runtime, const Value& container, const Value& item);

}  // namespace finemote::gen::expression
