// Texts to numbers, by Python's rules and independent of the locale.
#pragma once

#include <optional>
#include <string_view>

#include "generator/expression/integer.hpp"

namespace finemote::gen::expression {

/// Without the white space around it, as Python's strip() does.
std::string_view stripped(std::string_view text);

/// Python's int(text): blanks around, a sign, decimal digits, single underscores between digits.
std::optional<Integer> parse_integer(std::string_view text);

/// Python's float(text): also inf, infinity, nan; beyond the range it is inf or 0.
std::optional<double> parse_real(std::string_view text);

/// Removes underscores that stand between two digits; nothing when one stands elsewhere.
std::optional<std::string> without_underscores(std::string_view digits);

}  // namespace finemote::gen::expression
