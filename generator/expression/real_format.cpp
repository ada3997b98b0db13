#include "generator/expression/real_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "generator/expression/big_integer.hpp"
#include "generator/expression/layout.hpp"

namespace finemote::gen::expression {
namespace {

std::string digits_of(double magnitude, std::chars_format form, int precision) {
  std::string buffer(static_cast<std::size_t>(precision) + 400, '\0');
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), magnitude, form, precision).ptr;
  buffer.resize(static_cast<std::size_t>(end - buffer.data()));
  return buffer;
}

int exponent_of(const std::string& scientific) {
  const std::string exponent = scientific.substr(scientific.find('e') + 1);
  return std::stoi(exponent);
}

std::string without_trailing_zeros(std::string number) {
  const auto mark = std::min(number.find('e'), number.size());
  std::string mantissa = number.substr(0, mark);
  if (mantissa.find('.') != std::string::npos) {
    mantissa.erase(mantissa.find_last_not_of('0') + 1);
    if (mantissa.back() == '.') mantissa.pop_back();
  }
  return mantissa + number.substr(mark);
}

std::string general(double magnitude, int precision, bool alternate) {
  const int significant = std::max(precision, 1);
  const std::string scientific = digits_of(magnitude, std::chars_format::scientific, significant - 1);
  const int exponent = exponent_of(scientific);
  const bool is_fixed = exponent >= -4 && exponent < significant;
  std::string text = is_fixed ? digits_of(magnitude, std::chars_format::fixed, significant - 1 - exponent) : scientific;
  return alternate ? text : without_trailing_zeros(std::move(text));
}

/// Rounds a float to a multiple of 10^places, places > 0.
double round_left_of_point(double value, long places) {
  if (places > 309) return std::copysign(0.0, value);
  const double magnitude = std::abs(value);
  const BigInteger whole = big_of(integer_of(magnitude));
  const bool has_fraction = magnitude != std::trunc(magnitude);
  const BigInteger unit = boost::multiprecision::pow(BigInteger(10), static_cast<unsigned>(places));
  BigInteger quotient;
  BigInteger rest;
  boost::multiprecision::divide_qr(whole, unit, quotient, rest);
  const BigInteger twice = rest * 2;
  const bool is_tie = twice == unit && !has_fraction;
  const bool up = twice > unit || (twice == unit && has_fraction) || (is_tie && (quotient & 1) != 0);
  if (up) quotient += 1;
  return std::copysign(integer_from(quotient * unit).to_double(), value);
}

}  // namespace

std::string format_magnitude(double value, char type, int precision, bool alternate) {
  const bool is_capital = std::isupper(static_cast<unsigned char>(type)) != 0;
  const double magnitude = std::abs(value);
  std::string text;
  if (std::isnan(value)) {
    text = "nan";
  } else if (std::isinf(value)) {
    text = "inf";
  } else if (type == 'e' || type == 'E') {
    text = digits_of(magnitude, std::chars_format::scientific, precision);
  } else if (type == 'f' || type == 'F') {
    text = digits_of(magnitude, std::chars_format::fixed, precision);
  } else {
    text = general(magnitude, precision, alternate);
  }
  if (alternate && precision == 0 && text.find('.') == std::string::npos && std::isfinite(value)) {
    text.insert(std::min(text.find('e'), text.size()), ".");
  }
  return is_capital ? with_capitals(std::move(text)) : text;
}

double round_to(double value, long digits) {
  if (!std::isfinite(value) || digits > 323) return value;
  if (digits < 0) return round_left_of_point(value, -digits);
  const std::string text = digits_of(std::abs(value), std::chars_format::fixed, static_cast<int>(digits));
  double rounded = 0;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return std::copysign(rounded, value);
}

}  // namespace finemote::gen::expression
