// What a text says where a value is meant: properties, arguments and conditions are written as texts.
#pragma once

#include <optional>
#include <string>

#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

/// A property: '...' loses its quotes, then int, float, boolean as Python reads them; a text with an underscore stays
/// one. Other values stay as they are.
Value literal_of(Value value);

/// An argument as $(eval) sees it: a number or boolean where its text is one.
Value argument_literal(const std::string& text);

/// A condition: true, false or a whole number as a text, Python's bool(value) for others; nothing for another text.
std::optional<bool> boolean_literal(const Value& value);

}  // namespace finemote::gen::expression
