#include "generator/units/physical.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

namespace finemote::gen::units {
namespace {

constexpr double kPi = std::numbers::pi;

/// One `unit` is `factor` of `to`.
struct Conversion {
  std::string_view unit, to;
  double factor;
};

// The SI brochure (9th edition), tables 8 and 9; inch, foot and pound: NIST Handbook 44, appendix C.
constexpr Conversion kConversions[] = {
    {"deg", "rad", kPi / 180},
    {"degree", "rad", kPi / 180},
    {"degrees", "rad", kPi / 180},
    {"\xc2\xb0", "rad", kPi / 180},
    {"turn", "rad", 2 * kPi},
    {"rev", "rad", 2 * kPi},
    {"deg/s", "rad/s", kPi / 180},
    {"dps", "rad/s", kPi / 180},
    {"\xc2\xb0/s", "rad/s", kPi / 180},
    {"rpm", "rad/s", 2 * kPi / 60},
    {"rps", "rad/s", 2 * kPi},
    {"in", "m", 0.0254},
    {"inch", "m", 0.0254},
    {"ft", "m", 0.3048},
    {"km/h", "m/s", 1 / 3.6},
    {"kph", "m/s", 1 / 3.6},
    {"mph", "m/s", 0.44704},
    {"kn", "m/s", 1852.0 / 3600},
    {"kgf", "N", 9.80665},
    {"lbf", "N", 4.4482216152605},
    {"kgf cm", "N m", 0.0980665},
    {"kg cm", "N m", 0.0980665},
    {"bar", "Pa", 1e5},
    {"mbar", "Pa", 100},
    {"psi", "Pa", 6894.757293168},
    {"atm", "Pa", 101325},
    {"g", "kg", 1e-3},
    {"lb", "kg", 0.45359237},
    {"g/cm^3", "kg/m^3", 1000},
    {"kg/l", "kg/m^3", 1000},
    {"C", "degC", 1},
    {"\xc2\xb0"
     "C",
     "degC", 1},
    {"Hz", "1/s", 1},
    {"kHz", "1/s", 1000},
    {"min", "s", 60},
    {"h", "s", 3600},
    {"%", "", 0.01},
};

struct Prefix {
  std::string_view text;
  double factor;
};
constexpr Prefix kPrefixes[] = {{"n", 1e-9}, {"u", 1e-6}, {"\xc2\xb5", 1e-6}, {"m", 1e-3}, {"c", 1e-2},
                                {"d", 1e-1}, {"h", 1e2},  {"k", 1e3},         {"M", 1e6},  {"G", 1e9}};

/// `N*m`, `N.m`, `Nm` and `N m` are spellings of one unit, `m/s2` and `m/s^2` of another.
std::string spelling(std::string_view unit) {
  std::string plain;
  for (const char c : unit) {
    if (c != ' ' && c != '*' && c != '.' && c != '^') plain += c;
  }
  return plain;
}

/// Whether a prefix before `unit`, as spelling() gives it, scales it by itself: not before a power (`m2`) or a number.
bool begins_with_unit(std::string_view unit) {
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto end = std::find_if_not(unit.begin(), unit.end(), is_letter);
  return end != unit.begin() && (end == unit.end() || std::isdigit(static_cast<unsigned char>(*end)) == 0);
}

std::optional<double> factor_of(std::string_view unit, std::string_view to) {
  const std::string from = spelling(unit), wanted = is_bare(to) ? std::string() : spelling(to);
  if (from == wanted) return 1.0;
  for (const Conversion& conversion : kConversions) {
    if (spelling(conversion.unit) == from && spelling(conversion.to) == wanted) return conversion.factor;
  }
  const bool takes_prefix = begins_with_unit(wanted);
  for (const Prefix& prefix : kPrefixes) {
    if (takes_prefix && from == std::string(prefix.text) + wanted) return prefix.factor;
  }
  return std::nullopt;
}

}  // namespace

bool is_bare(std::string_view unit) { return unit.empty() || unit == "1"; }

bool looks_like_unit(std::string_view text) {
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || (c & 0x80) != 0; };
  const auto belongs = [&](char c) {
    return is_letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("/^* .%()-").find(c) != std::string_view::npos;
  };
  if (text.empty() || !std::all_of(text.begin(), text.end(), belongs)) return false;
  const bool is_number_part = std::string_view("eExX").find(text.front()) != std::string_view::npos;  // of 1e, 0x1
  return (is_letter(text.front()) && !is_number_part) || text.front() == '%';
}

std::string convert(std::string_view number, std::string_view unit, std::string_view to) {
  const auto factor = factor_of(unit, to);
  if (!factor) return {};
  if (!number.empty() && number.front() == '+') number.remove_prefix(1);
  double value = 0;
  const auto [end, problem] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (problem != std::errc() || end != number.data() + number.size()) return {};
  return fmt::format("{:.12g}", value * *factor);
}

}  // namespace finemote::gen::units
