// Numbers without conversion: what `index channel id address` are, and values of params.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "generator/units/physical.hpp"
#include "generator/units/scan.hpp"

namespace finemote::gen::units {
namespace {

/// Length of a signed integer (decimal or 0x), or of a signed real; 0 when there is none.
std::size_t integer_length(std::string_view text) {
  const std::size_t sign = !text.empty() && (text.front() == '-' || text.front() == '+') ? 1 : 0;
  if (text.substr(sign, 2) == "0x" || text.substr(sign, 2) == "0X") {
    std::size_t end = sign + 2;
    while (end < text.size() && std::string_view("0123456789abcdefABCDEF").find(text[end]) != std::string_view::npos)
      ++end;
    return end > sign + 2 ? end : 0;
  }
  const std::size_t digits = count_digits(text.substr(sign));
  return digits == 0 ? 0 : sign + digits;
}

std::size_t real_length(std::string_view text) {
  const std::size_t sign = !text.empty() && (text.front() == '-' || text.front() == '+') ? 1 : 0;
  const std::size_t number = number_length(text.substr(sign));
  if (number == 0) return 0;
  std::size_t end = sign + number;
  if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    std::size_t exponent = end + 1;
    if (exponent < text.size() && (text[exponent] == '-' || text[exponent] == '+')) ++exponent;
    const std::size_t digits = count_digits(text.substr(exponent));
    if (digits > 0) end = exponent + digits;
  }
  return end;
}

constexpr std::string_view kWholeNumber = "a whole number";

/// What follows a number (`rest`) although it is neither nothing nor `unit`.
Fault not_the_unit(std::string_view text, std::string_view rest, std::string_view unit, std::string_view noun) {
  const std::string_view number = text.substr(0, text.size() - rest.size());
  if (rest.starts_with(' ')) rest.remove_prefix(1);
  if (!looks_like_unit(rest)) {
    std::string pointed(text);
    std::replace(pointed.begin(), pointed.end(), ',', '.');
    const bool has_comma = rest.starts_with(',') && real_length(pointed) == pointed.size();
    return {code::quantity_malformed, fmt::format("'{}' is not {}", shown(text), noun),
            has_comma ? fmt::format("write '{}'", pointed) : std::string()};
  }
  std::string converted = convert(number, rest, unit);
  if (noun == kWholeNumber && converted.find_first_of(".e") != std::string::npos) converted.clear();
  if (is_bare(unit)) {
    return {code::unit_wrong, fmt::format("'{}' has a unit, expected {} without one", shown(text), noun),
            converted.empty() ? std::string() : fmt::format("write '{}'", converted)};
  }
  const std::string base = fmt::format("the unit is {}", unit);
  return {code::unit_wrong, fmt::format("'{}' is not {} in '{}'", shown(text), noun, unit),
          converted.empty() ? base : fmt::format("write '{} {}'; {}", converted, unit, base)};
}

/// Nothing when the unit, or nothing, follows the number; else the fault.
std::optional<Fault> check_unit(std::string_view text, std::string_view rest, std::string_view unit,
                                std::string_view noun) {
  const bool has_unit = !is_bare(unit) && (rest == unit || (rest.substr(0, 1) == " " && rest.substr(1) == unit));
  if (rest.empty() || has_unit) return {};
  return not_the_unit(text, rest, unit, noun);
}

Fault not_a(std::string_view text, std::string_view noun) {
  return {
      code::quantity_malformed,
      text.empty() ? fmt::format("empty value, expected {}", noun) : fmt::format("'{}' is not {}", shown(text), noun),
      {}};
}

/// Of a decimal number that no double holds: it is too small, not too large.
bool is_below_one(std::string_view number) {
  const std::size_t mark = std::min(number.find_first_of("eE"), number.size());
  if (mark < number.size()) return number[mark + 1] == '-';
  const std::string_view digits = number.substr(0, mark);
  return digits.find_first_of("123456789") > digits.find('.');
}

}  // namespace

Result<std::uint32_t> parse_bare(std::string_view text) {
  const bool hex = text.size() > 2 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
  const std::string_view digits = hex ? text.substr(2) : text;
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, hex ? 16 : 10);
  if (error == std::errc::result_out_of_range) return too_large(text);
  if (error != std::errc() || end != digits.data() + digits.size()) {
    return Fault{code::bare_integer, fmt::format("'{}' is not a whole number", shown(text)),
                 "write a decimal or 0x number without unit"};
  }
  return value;
}

Result<std::int64_t> parse_integer(std::string_view text, std::string_view unit) {
  const std::size_t length = integer_length(text);
  if (length == 0) return not_a(text, kWholeNumber);
  if (auto fault = check_unit(text, text.substr(length), unit, kWholeNumber)) return *fault;
  std::string_view digits = text.substr(0, length);
  const bool negative = digits.front() == '-';
  if (negative || digits.front() == '+') digits.remove_prefix(1);
  const bool hex = digits.size() > 2 && (digits[1] == 'x' || digits[1] == 'X');
  if (hex) digits.remove_prefix(2);
  std::uint64_t magnitude = 0;
  const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), magnitude, hex ? 16 : 10);
  constexpr auto kMost = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  if (parsed.ec != std::errc() || magnitude > kMost) return too_large(text);
  const auto value = static_cast<std::int64_t>(magnitude);
  return negative ? -value : value;
}

Result<double> parse_real(std::string_view text, std::string_view unit) {
  constexpr std::string_view kNoun = "a number";
  const std::size_t length = real_length(text);
  if (length == 0) return not_a(text, kNoun);
  if (auto fault = check_unit(text, text.substr(length), unit, kNoun)) return *fault;
  std::string_view number = text.substr(0, length);
  if (number.front() == '+') number.remove_prefix(1);
  double value = 0;
  const auto parsed = std::from_chars(number.data(), number.data() + number.size(), value);
  if (parsed.ec == std::errc()) return value;
  if (!is_below_one(number)) return too_large(text);
  // not zero: a range that holds zero need not hold this number, and no float holds it
  return std::copysign(std::numeric_limits<double>::min(), number.front() == '-' ? -1.0 : 1.0);
}

}  // namespace finemote::gen::units
