#include "generator/units/scan.hpp"

#include <fmt/format.h>

namespace finemote::gen::units {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::size_t count_digits(std::string_view text) {
  std::size_t n = 0;
  while (n < text.size() && is_digit(text[n])) ++n;
  return n;
}

std::size_t number_length(std::string_view text) {
  const std::size_t whole = count_digits(text);
  if (whole == 0 || whole == text.size() || text[whole] != '.') return whole;
  const std::size_t fraction = count_digits(text.substr(whole + 1));
  return fraction == 0 ? whole : whole + 1 + fraction;
}

std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  if (text.size() <= kLongest) return std::string(text);
  const auto is_inside_letter = [&](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U; };
  std::size_t end = kLongest;
  while (end > 0 && is_inside_letter(end)) --end;  // UTF-8
  return std::string(text.substr(0, end)) + "...";
}

Fault too_large(std::string_view text) {
  return {code::quantity_overflow, fmt::format("'{}' is too large", shown(text)),
          "values fit 63 bits in their base unit, bare numbers 32 bits"};
}

}  // namespace finemote::gen::units
