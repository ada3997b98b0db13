#include "generator/expression/layout.hpp"

#include <algorithm>

#include "generator/expression/failure.hpp"
#include "generator/expression/letters.hpp"
#include "generator/expression/utf8.hpp"

namespace finemote::gen::expression {
std::size_t read_count(std::string_view pattern, std::size_t& at) {
  std::size_t count = 0;
  for (; at < pattern.size() && is_digit(pattern[at]); ++at) {
    count = count * 10 + static_cast<std::size_t>(pattern[at] - '0');
    if (count > kMaxWidth) fail_limit("the width of a format is too large");
  }
  return count;
}

std::string pad(std::string text, std::size_t width, char align, const std::string& fill) {
  const std::size_t length = count_characters(text);
  if (length >= width) return text;
  const std::size_t missing = width - length;
  const std::size_t left = align == '<' ? 0 : align == '^' ? missing / 2 : missing;
  const auto repeat = [&](std::size_t times) {
    std::string out;
    for (std::size_t i = 0; i < times; ++i) out += fill;
    return out;
  };
  return repeat(left) + text + repeat(missing - left);
}

std::string pad_with_zeros(const std::string& sign, const std::string& digits, std::size_t width) {
  const std::size_t length = sign.size() + digits.size();
  return sign + std::string(length < width ? width - length : 0, '0') + digits;
}

std::string character_of(const Integer& code) {
  if (!code.is_small() || code.small() < 0 || code.small() > 0x10FFFF) fail_eval("%c arg not in range(0x110000)");
  if (code.small() >= 0xD800 && code.small() <= 0xDFFF) fail_eval("surrogates not allowed");
  return encode(static_cast<char32_t>(code.small()));
}

std::string shortened(std::string text, const std::optional<std::size_t>& most) {
  if (!most || count_characters(text) <= *most) return text;
  const auto characters = split_characters(text);
  std::string cut;
  for (std::size_t i = 0; i < *most; ++i) cut += characters[i];
  return cut;
}

std::string with_capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) { return c >= 'a' && c <= 'z' ? c - 32 : c; });
  return text;
}

std::string integer_digits(const Integer& i, char type) {
  const Integer magnitude = i.is_negative() ? -i : i;
  switch (type) {
    case 'x':
      return magnitude.to_string(16);
    case 'X':
      return with_capitals(magnitude.to_string(16));
    case 'o':
      return magnitude.to_string(8);
    case 'b':
      return magnitude.to_string(2);
    default:
      return magnitude.to_string();
  }
}

}  // namespace finemote::gen::expression
