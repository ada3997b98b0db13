// Which type a plain YAML 1.1 scalar has: https://yaml.org/type/ with the regular expressions of PyYAML.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "generator/expression/letters.hpp"
#include "generator/expression/number.hpp"
#include "generator/expression/yaml.hpp"

namespace finemote::gen::expression {
namespace {

bool is_digit_or_underscore(char c) { return is_digit(c) || c == '_'; }

template <std::size_t N>
bool is_one_of(const std::array<std::string_view, N>& words, std::string_view text) {
  return std::find(words.begin(), words.end(), text) != words.end();
}

constexpr std::array<std::string_view, 9> kTrue = {"yes", "Yes", "YES", "true", "True", "TRUE", "on", "On", "ON"};
constexpr std::array<std::string_view, 9> kFalse = {"no", "No", "NO", "false", "False", "FALSE", "off", "Off", "OFF"};
constexpr std::array<std::string_view, 5> kNull = {"", "~", "null", "Null", "NULL"};

std::string without_underscore(std::string_view text) {
  std::string out(text);
  out.erase(std::remove(out.begin(), out.end(), '_'), out.end());
  return out;
}

template <typename Test>
bool all(std::string_view text, Test test) {
  return !text.empty() && std::all_of(text.begin(), text.end(), test);
}

/// `(:[0-5]?[0-9])+` after the first digits.
bool is_sexagesimal_tail(std::string_view tail) {
  while (tail.starts_with(':')) {
    tail.remove_prefix(1);
    const auto end = std::min(tail.find(':'), tail.size());
    const std::string_view part = tail.substr(0, end);
    const bool fits = all(part, is_digit) && (part.size() == 1 || (part.size() == 2 && part[0] <= '5'));
    if (!fits) return false;
    tail.remove_prefix(end);
    if (tail.empty()) return true;
  }
  return false;
}

/// a:b:c in base 60.
template <typename Number, typename Parse>
Number base_60(std::string_view text, Parse parse) {
  Number total = 0;
  for (;;) {
    const auto end = std::min(text.find(':'), text.size());
    total = total * Number(60) + parse(text.substr(0, end));
    if (end == text.size()) return total;
    text.remove_prefix(end + 1);
  }
}

Integer decimal(std::string_view text) { return parse_digits(without_underscore(text), 10).value_or(Integer(0)); }

std::optional<Integer> unsigned_integer(std::string_view text) {
  if (text == "0") return 0;
  if (text.starts_with("0b")) return parse_digits(without_underscore(text.substr(2)), 2);
  if (text.starts_with("0x")) return parse_digits(without_underscore(text.substr(2)), 16);
  if (text.starts_with('0')) return parse_digits(without_underscore(text.substr(1)), 8);
  if (!is_digit(text[0])) return std::nullopt;
  if (all(text, is_digit_or_underscore)) return decimal(text);
  const auto colon = text.find(':');
  const bool is_base_60 = colon != std::string_view::npos && all(text.substr(0, colon), is_digit_or_underscore) &&
                          is_sexagesimal_tail(text.substr(colon));
  if (!is_base_60) return std::nullopt;
  return base_60<Integer>(text, decimal);
}

/// `digits . digits [e sign digits]`; without digits before the point there must be one after it.
bool is_plain_real(std::string_view text, bool has_sign) {
  const auto point = text.find('.');
  if (point == std::string_view::npos) return false;
  std::string_view fraction = text.substr(point + 1);
  if (const auto mark = fraction.find_first_of("eE"); mark != std::string_view::npos) {
    const std::string_view exponent = fraction.substr(mark + 1);
    const bool fits =
        exponent.size() > 1 && (exponent[0] == '+' || exponent[0] == '-') && all(exponent.substr(1), is_digit);
    if (!fits) return false;
    fraction = fraction.substr(0, mark);
  }
  if (!fraction.empty() && !all(fraction, is_digit_or_underscore)) return false;
  if (point == 0) return !has_sign && !fraction.empty() && is_digit(fraction[0]);
  return is_digit(text[0]) && all(text.substr(0, point), is_digit_or_underscore);
}

std::optional<double> unsigned_real(std::string_view text, bool has_sign) {
  if (text == ".inf" || text == ".Inf" || text == ".INF") return std::numeric_limits<double>::infinity();
  if (!has_sign && (text == ".nan" || text == ".NaN" || text == ".NAN"))
    return std::numeric_limits<double>::quiet_NaN();
  if (is_plain_real(text, has_sign)) return parse_real(without_underscore(text));
  const auto colon = text.find(':');
  const auto point = text.find('.');
  const bool may_be_base_60 = colon != std::string_view::npos && point != std::string_view::npos && colon < point;
  if (!may_be_base_60) return std::nullopt;
  const bool is_base_60 = is_digit(text[0]) && all(text.substr(0, colon), is_digit_or_underscore) &&
                          is_sexagesimal_tail(text.substr(colon, point - colon)) &&
                          (point + 1 == text.size() || all(text.substr(point + 1), is_digit_or_underscore));
  if (!is_base_60) return std::nullopt;
  return base_60<double>(text,
                         [](std::string_view part) { return parse_real(without_underscore(part)).value_or(0.0); });
}

}  // namespace

Value yaml_scalar(const std::string& text) {
  if (is_one_of(kNull, text)) return {};
  if (is_one_of(kTrue, text)) return true;
  if (is_one_of(kFalse, text)) return false;
  std::string_view magnitude = text;
  const bool negative = magnitude.starts_with('-');
  const bool has_sign = negative || magnitude.starts_with('+');
  if (has_sign) magnitude.remove_prefix(1);
  if (magnitude.empty()) return text;
  if (const auto i = unsigned_integer(magnitude)) return negative ? -*i : *i;
  if (const auto d = unsigned_real(magnitude, has_sign)) return negative ? -*d : *d;
  return text;
}

}  // namespace finemote::gen::expression
