// Equality, order and hash of values, as Python defines them: 1 == 1.0 == True, lists by content.
#pragma once

#include <cstddef>

#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

class Runtime;

bool equal(Runtime& runtime, const Value& a, const Value& b);

/// a < b, a <= b ...; `symbol` is the operator for the message when the types have no order.
bool ordered(Runtime& runtime, const Value& a, const Value& b, std::string_view symbol);

/// Python's `a is b`.
bool identical(const Value& a, const Value& b);

/// Equal values have equal hashes; fails for lists, dicts and sets.
std::size_t hash_of(Runtime& runtime, const Value& value);

/// Sorts in place, stable; fails where two items have no order.
void sort_values(Runtime& runtime, Values& items, bool reverse);

}  // namespace finemote::gen::expression
