// How much of a text, from its start, is a number.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "generator/units/units.hpp"

namespace finemote::gen::units {

bool is_digit(char c);

/// The number of decimal digits at the start of the text.
std::size_t count_digits(std::string_view text);

/// Length of the match of `[0-9]+(\.[0-9]+)?` at the start of the text; 0 when there is none.
std::size_t number_length(std::string_view text);

/// The text as messages show it: cut off where it is long.
std::string shown(std::string_view text);

/// FM3034.
Fault too_large(std::string_view text);

}  // namespace finemote::gen::units
