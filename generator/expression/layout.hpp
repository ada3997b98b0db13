// Texts and numbers laid out in the width of a format, for '%5.2f' and '{:>8}' alike.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "generator/expression/integer.hpp"

namespace finemote::gen::expression {

inline constexpr std::size_t kMaxWidth = 1'000'000;  ///< of a format, and its most digits

/// A number in a pattern; moves `at` past it. Fails beyond kMaxWidth.
std::size_t read_count(std::string_view pattern, std::size_t& at);

/// Fills a text up to `width` characters; `align` is '<', '^' or '>'.
std::string pad(std::string text, std::size_t width, char align, const std::string& fill);

/// Zeros between the sign (and 0x) and the digits.
std::string pad_with_zeros(const std::string& sign, const std::string& digits, std::size_t width);

/// The character of a code point. Fails where there is none, and on surrogates, which no text can hold.
std::string character_of(const Integer& code);

/// At most the first `most` characters.
std::string shortened(std::string text, const std::optional<std::size_t>& most);

/// ASCII letters alone.
std::string with_capitals(std::string text);

/// The digits of |i| in the base that a format letter stands for: d x X o b.
std::string integer_digits(const Integer& i, char type);

}  // namespace finemote::gen::expression
