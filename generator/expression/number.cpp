#include "generator/expression/number.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <string>

#include "generator/expression/letters.hpp"
#include "generator/xml/write.hpp"

namespace finemote::gen::expression {
namespace {

bool is_alnum(char c) { return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? c + 32 : c; });
  return out;
}

/// `digits [. digits] [e [sign] digits]` with at least one digit before the exponent.
bool is_decimal_text(std::string_view text) {
  std::size_t at = 0;
  const auto digits = [&] {
    const std::size_t begin = at;
    while (at < text.size() && is_digit(text[at])) ++at;
    return at - begin;
  };
  std::size_t mantissa = digits();
  if (at < text.size() && text[at] == '.') ++at, mantissa += digits();
  if (mantissa == 0) return false;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
    if (digits() == 0) return false;
  }
  return at == text.size();
}

/// What a decimal beyond the range of double is: infinite when its first digit stands for 1 or more.
double out_of_range(std::string_view text) {
  const auto mark = std::min(text.find_first_of("eE"), text.size());
  long exponent = 0;
  if (mark < text.size()) {
    const std::string_view digits = text.substr(mark + 1 + (text[mark + 1] == '+' ? 1 : 0));
    if (std::from_chars(digits.data(), digits.data() + digits.size(), exponent).ec != std::errc()) {
      exponent = digits[0] == '-' ? std::numeric_limits<int>::min() : std::numeric_limits<int>::max();
    }
  }
  const std::string_view mantissa = text.substr(0, mark);
  const auto first = mantissa.find_first_of("123456789");
  if (first == std::string_view::npos) return 0.0;
  const auto point = std::min(mantissa.find('.'), mantissa.size());
  const long power = first < point ? static_cast<long>(point - first) : -static_cast<long>(first - point);
  return power + exponent > 0 ? std::numeric_limits<double>::infinity() : 0.0;
}

}  // namespace

std::string_view stripped(std::string_view text) {
  while (!text.empty() && xml::is_blank_text(text.substr(0, 1))) text.remove_prefix(1);
  while (!text.empty() && xml::is_blank_text(text.substr(text.size() - 1))) text.remove_suffix(1);
  return text;
}

std::optional<std::string> without_underscores(std::string_view digits) {
  if (digits.find('_') == std::string_view::npos) return std::string(digits);
  std::string out;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (digits[i] != '_') {
      out += digits[i];
      continue;
    }
    const bool between = i > 0 && i + 1 < digits.size() && is_alnum(digits[i - 1]) && is_alnum(digits[i + 1]);
    if (!between) return std::nullopt;
  }
  return out;
}

std::optional<Integer> parse_integer(std::string_view text) {
  text = stripped(text);
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  if (text.empty() || !is_digit(text[0])) return std::nullopt;
  const auto digits = without_underscores(text);
  if (!digits) return std::nullopt;
  auto value = parse_digits(*digits, 10);
  return value && negative ? std::optional<Integer>(-*value) : value;
}

std::optional<double> parse_real(std::string_view text) {
  text = stripped(text);
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  const double sign = negative ? -1.0 : 1.0;
  if (text.empty()) return std::nullopt;
  if (!is_digit(text[0]) && text[0] != '.') {
    const std::string word = text.size() <= std::string_view("infinity").size() ? lower(text) : std::string();
    if (word == "inf" || word == "infinity") return sign * std::numeric_limits<double>::infinity();
    if (word == "nan") return std::numeric_limits<double>::quiet_NaN();
    return std::nullopt;
  }
  const auto digits = without_underscores(text);
  if (!digits || !is_decimal_text(*digits)) return std::nullopt;
  double value = 0;
  const auto result = std::from_chars(digits->data(), digits->data() + digits->size(), value);
  if (result.ec == std::errc::result_out_of_range) value = out_of_range(*digits);
  return sign * value;
}

}  // namespace finemote::gen::expression
