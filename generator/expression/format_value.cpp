// One value by the text after the colon of a replacement field.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/expression/cost.hpp"
#include "generator/expression/format.hpp"
#include "generator/expression/layout.hpp"
#include "generator/expression/letters.hpp"
#include "generator/expression/number.hpp"
#include "generator/expression/print.hpp"
#include "generator/expression/real_format.hpp"
#include "generator/expression/runtime.hpp"
#include "generator/expression/utf8.hpp"

namespace finemote::gen::expression {
namespace {

struct Specification {
  std::string fill;  ///< empty: not given
  char align = '\0';
  char sign = '-';
  bool alternate = false;
  bool zero = false;
  char grouping = '\0';
  std::size_t width = 0;
  std::optional<std::size_t> precision;
  char type = '\0';
};

/// A 0 before the width fills with zeros where no other fill is given.
std::string fill_of(const Specification& s) { return !s.fill.empty() ? s.fill : s.zero ? "0" : " "; }

void check_grouping(const Specification& s, const Value& value) {
  const char type = s.type == '\0' && value.text() != nullptr ? 's' : s.type;
  const std::string_view types = s.grouping == '_' ? "defgEG%FboxX" : "defgEG%F";
  if (s.grouping == '\0' || type == '\0' || types.find(type) != std::string_view::npos) return;
  fail_eval(fmt::format("Cannot specify '{}' with '{}'.", s.grouping, type));
}

bool is_align(char c) { return c == '<' || c == '>' || c == '^' || c == '='; }

Specification parse_specification(std::string_view text, const Value& value) {
  Specification s;
  std::size_t at = 0;
  const auto characters = split_characters(text);
  if (characters.size() > 1 && is_align(characters[1][0])) {
    s.fill = characters[0];
    s.align = characters[1][0];
    at = characters[0].size() + 1;
  } else if (!text.empty() && is_align(text[0])) {
    s.align = text[at++];
  }
  const auto accept = [&](std::string_view any) {
    return at < text.size() && any.find(text[at]) != std::string_view::npos;
  };
  if (accept("+- ")) s.sign = text[at++];
  if (accept("#")) s.alternate = true, ++at;
  if (accept("0")) s.zero = true, ++at;
  s.width = read_count(text, at);
  if (accept(",_")) s.grouping = text[at++];
  if (accept(".")) {
    ++at;
    if (at >= text.size() || !is_digit(text[at])) fail_eval("Format specifier missing precision");
    s.precision = read_count(text, at);
  }
  if (at < text.size()) s.type = text[at++];
  if (at < text.size()) {
    fail_eval(fmt::format("Invalid format specifier '{}' for object of type '{}'", text, type_name(value)));
  }
  check_grouping(s, value);
  return s;
}

[[noreturn]] void fail_type(char type, const Value& value) {
  fail_eval(fmt::format("Unknown format code '{}' for object of type '{}'", type, type_name(value)));
}

/// The digits before a point, an exponent or a sign `%`, in groups of `every`, and what follows them. Zeros go before
/// them, in groups as well, until there are `width` characters: one more where a separator would come first.
std::string grouped(const std::string& digits, char separator, std::size_t every, std::size_t width) {
  const std::string_view digit = every == 3 ? "0123456789" : "0123456789abcdefABCDEF";
  const auto end = std::min(digits.find_first_not_of(digit), digits.size());
  if (end == 0) return digits;  // inf, nan
  const std::size_t rest = digits.size() - end;
  std::size_t count = end;
  while (count + (count - 1) / every + rest < width) ++count;
  std::string out;
  for (std::size_t left = count; left > 0; --left) {
    if (left < count && left % every == 0) out += separator;
    out += left > end ? '0' : digits[end - left];
  }
  return out + digits.substr(end);
}

/// @param every  digits of a group, where the specification asks for groups
std::string laid_out_number(const Specification& s, bool negative, std::string lead, std::string digits,
                            std::size_t every = 3) {
  lead.insert(0, negative ? "-" : s.sign == '+' ? "+" : s.sign == ' ' ? " " : "");
  const char align = s.align != '\0' ? s.align : s.zero ? '=' : '>';
  const std::string fill = fill_of(s);
  const std::size_t rest = s.width > lead.size() ? s.width - lead.size() : 0;
  const bool zeros = align == '=' && fill == "0";
  if (s.grouping != '\0') digits = grouped(digits, s.grouping, every, zeros ? rest : 0);
  if (align != '=') return pad(lead + digits, s.width, align, fill);
  return lead + pad(std::move(digits), rest, '>', fill);
}

std::string format_real(const Specification& s, const Value& value, double d) {
  std::string digits;
  switch (s.type) {
    case '\0':
      if (!s.precision) {
        digits = real_to_text(std::abs(d));
      } else {
        digits = format_magnitude(d, 'g', static_cast<int>(*s.precision), s.alternate);
        const bool is_whole = digits.find_first_of(".en") == std::string::npos;
        if (is_whole) digits += ".0";
      }
      break;
    case 'n':
      digits = format_magnitude(d, 'g', static_cast<int>(s.precision.value_or(6)), s.alternate);
      break;
    case 'e':
    case 'E':
    case 'f':
    case 'F':
    case 'g':
    case 'G':
      digits = format_magnitude(d, s.type, static_cast<int>(s.precision.value_or(6)), s.alternate);
      break;
    case '%':
      digits = format_magnitude(d * 100, 'f', static_cast<int>(s.precision.value_or(6)), s.alternate) + "%";
      break;
    default:
      fail_type(s.type, value);
  }
  return laid_out_number(s, std::signbit(d) && !std::isnan(d), "", digits);
}

std::string format_integer(const Specification& s, const Value& value, const Integer& i) {
  const char type = s.type == '\0' || s.type == 'n' ? 'd' : s.type;
  if (std::string_view("eEfFgG%").find(type) != std::string_view::npos) return format_real(s, value, i.to_double());
  if (type == 'c') return pad(character_of(i), s.width, s.align == '<' || s.align == '^' ? s.align : '>', fill_of(s));
  if (std::string_view("dxXob").find(type) == std::string_view::npos) fail_type(type, value);
  if (s.precision) fail_eval("Precision not allowed in integer format specifier");
  const std::string digits = integer_digits(i, type);
  const std::string lead = s.alternate && type != 'd' ? std::string("0") + type : "";
  return laid_out_number(s, i.is_negative(), lead, digits, type == 'd' ? 3 : 4);
}

std::string format_text(const Specification& s, const Value& value, std::string text) {
  if (s.type != '\0' && s.type != 's') fail_type(s.type, value);
  if (s.align == '=') fail_eval("'=' alignment not allowed in string format specifier");
  text = shortened(std::move(text), s.precision);
  return pad(std::move(text), s.width, s.align == '\0' ? '<' : s.align, fill_of(s));
}

}  // namespace

std::string format_value(Runtime& runtime, const Value& value, std::string_view specification) {
  if (specification.empty()) return to_text(runtime, value);
  runtime.budget.spend(cost_of_printing(value));
  const Specification s = parse_specification(specification, value);
  if (const double* d = as_real(value)) return format_real(s, value, *d);
  if (const auto i = as_integer(value)) return format_integer(s, value, *i);
  if (value.text() != nullptr) return format_text(s, value, *value.text());
  fail_eval(fmt::format("unsupported format string passed to {}.__format__", type_name(value)));
}

}  // namespace finemote::gen::expression
