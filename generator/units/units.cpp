#include "generator/units/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>

#include "generator/units/scan.hpp"

namespace finemote::gen::units {
namespace {

/// A unit and the power of ten that leads to the base unit.
struct UnitName {
  std::string_view text;
  int exponent;
};

/// One kind of quantity: its units, and what messages call it.
struct Kind {
  std::string_view article_name;  // "a duration"
  std::span<const UnitName> units;
  std::string_view base;
  std::string_view example_unit;
};

constexpr std::array<UnitName, 4> kTime{{{"ns", 0}, {"us", 3}, {"ms", 6}, {"s", 9}}};
constexpr std::array<UnitName, 3> kFrequency{{{"Hz", 0}, {"kHz", 3}, {"MHz", 6}}};
constexpr std::array<UnitName, 4> kBitrate{{{"bit/s", 0}, {"kbit/s", 3}, {"Mbit/s", 6}, {"baud", 0}}};
constexpr std::array<UnitName, 1> kBits{{{"bit", 0}}};
constexpr std::array<UnitName, 1> kPercent{{{"%", 0}}};

constexpr Kind kDurationKind{"a duration", kTime, "ns", "ms"};
constexpr Kind kFrequencyKind{"a frequency", kFrequency, "Hz", "kHz"};
constexpr Kind kBitrateKind{"a bit rate", kBitrate, "bit/s", "baud"};
constexpr Kind kBitsKind{"a number of bits", kBits, "bit", "bit"};
constexpr Kind kPercentKind{"a percentage", kPercent, "%", "%"};

std::string unit_list(const Kind& kind) {
  std::string list;
  for (const UnitName& unit : kind.units) {
    if (!list.empty()) list += ", ";
    list += unit.text;
  }
  return list;
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

std::string_view without_outer_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// `5  ms ` -> `5ms`: a number and a unit of the kind with blanks around or between them; else empty.
std::string without_blanks(std::string_view text, const Kind& kind) {
  const std::string_view inner = without_outer_blanks(text);
  const std::size_t length = number_length(inner);
  const std::string_view unit = without_outer_blanks(inner.substr(length));
  const bool is_known = std::any_of(kind.units.begin(), kind.units.end(),
                                    [&](const UnitName& candidate) { return unit == candidate.text; });
  return length > 0 && is_known ? std::string(inner.substr(0, length)) + std::string(unit) : std::string();
}

Fault malformed(std::string_view text, const Kind& kind) {
  if (const std::string packed = without_blanks(text, kind); !packed.empty()) {
    return {code::quantity_malformed, fmt::format("'{}' has a blank too many", shown(text)),
            fmt::format("write '{}'", shown(packed))};
  }
  const std::string example = fmt::format("write a number and a unit, for example '10{}'", kind.example_unit);
  if (const std::size_t comma = text.find(','); comma != std::string_view::npos && comma + 1 < text.size()) {
    std::string pointed(text);
    pointed[comma] = '.';
    return {code::quantity_malformed, fmt::format("'{}' has a decimal comma", shown(text)),
            fmt::format("write '{}'", shown(pointed))};
  }
  if (text.empty())
    return {code::quantity_malformed, fmt::format("empty value, expected {}", kind.article_name), example};
  if (text.front() == '-') {
    return {code::quantity_malformed, fmt::format("'{}' is negative, expected {}", shown(text), kind.article_name),
            example};
  }
  return {code::quantity_malformed, fmt::format("'{}' is not {}", shown(text), kind.article_name), example};
}

/// `0.4` -> `40`, `0.125` -> `12.5`: the point two places to the right.
std::string percent_of(std::string_view fraction) {
  std::string digits(fraction.substr(2));
  while (digits.size() < 2) digits += '0';
  std::string whole = digits.substr(0, 2);
  whole.erase(0, std::min(whole.find_first_not_of('0'), whole.size() - 1));
  const std::string rest = digits.substr(2);
  return rest.empty() ? whole : whole + "." + rest;
}

/// What a number without unit probably means: rates are often given in the base unit, fractions for percent.
std::string guess(std::string_view text, const Kind& kind) {
  const bool is_large = text.size() > 3 && text.find('.') == std::string_view::npos;
  const bool is_fraction = text.size() > 2 && text.substr(0, 2) == "0.";
  if (kind.base == "%" && is_fraction)
    return fmt::format("write '{}%' for the fraction {}", percent_of(text), shown(text));
  const bool in_base = kind.units.size() == 1 || (kind.base == "Hz" && is_large);
  return fmt::format("write '{}{}'", shown(text), in_base ? kind.base : kind.example_unit);
}

Fault no_unit(std::string_view text, const Kind& kind) {
  const std::string others = kind.units.size() == 1 ? "" : fmt::format("; units are {}", unit_list(kind));
  return {code::unit_missing, fmt::format("'{}' has no unit, expected {}", shown(text), kind.article_name),
          guess(text, kind) + others};
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (lower(a[i]) != lower(b[i])) return false;
  }
  return true;
}

/// Other spellings of a unit that are in use elsewhere.
struct ForeignUnit {
  std::string_view text;  ///< in lower case
  std::string_view ours;
};
constexpr ForeignUnit kForeign[] = {
    {"\xc2\xb5s", "us"}, {"\xce\xbcs", "us"}, {"usec", "us"},      {"msec", "ms"},         {"nsec", "ns"},
    {"sec", "s"},        {"seconds", "s"},    {"second", "s"},     {"microseconds", "us"}, {"milliseconds", "ms"},
    {"millis", "ms"},    {"micros", "us"},    {"bps", "bit/s"},    {"kbps", "kbit/s"},     {"mbps", "Mbit/s"},
    {"kbaud", "kbit/s"}, {"mbaud", "Mbit/s"}, {"bits/s", "bit/s"}, {"kbits/s", "kbit/s"},  {"mbits/s", "Mbit/s"},
    {"bit", "bit/s"},    {"kbit", "kbit/s"},  {"mbit", "Mbit/s"},  {"bd", "baud"},         {"bauds", "baud"},
    {"k", "kHz"},        {"m", "MHz"},        {"bits", "bit"},     {"percent", "%"},       {"pct", "%"}};

/// The unit of this kind that is meant by a spelling from elsewhere; empty when there is none.
std::string_view meant_unit(std::string_view unit, const Kind& kind) {
  for (const ForeignUnit& foreign : kForeign) {
    if (!equal_ignoring_case(unit, foreign.text)) continue;
    for (const UnitName& candidate : kind.units) {
      if (candidate.text == foreign.ours) return candidate.text;
    }
  }
  return {};
}

/// A number and its unit, separated.
struct Parts {
  std::string_view number;
  int exponent = 0;
  std::string_view unit;
};

Fault other_unit(std::string_view number, std::string_view unit, const Kind& kind);

Result<Parts> split(std::string_view text, const Kind& kind) {
  const std::size_t length = number_length(text);
  if (length == 0) return malformed(text, kind);
  const std::string_view number = text.substr(0, length);
  std::string_view rest = text.substr(length);
  if (rest.empty()) return no_unit(text, kind);
  if (rest.starts_with(' ')) rest.remove_prefix(1);
  if (rest.empty() || rest.front() == ' ' || rest.front() == '.' || rest.front() == ',' || rest.front() == '\t' ||
      rest.front() == '\n')
    return malformed(text, kind);
  for (const UnitName& unit : kind.units) {
    if (rest == unit.text) return Parts{number, unit.exponent, rest};
  }
  if (rest.find(' ') != std::string_view::npos || is_digit(rest.front())) return malformed(text, kind);
  return other_unit(number, rest, kind);
}

/// Adds decimal digits to `value`; false when it leaves 63 bits.
bool append_digits(std::int64_t& value, std::string_view digits) {
  for (const char c : digits) {
    if (__builtin_mul_overflow(value, std::int64_t{10}, &value)) return false;
    if (__builtin_add_overflow(value, std::int64_t{c - '0'}, &value)) return false;
  }
  return true;
}

/// The value cut off after its last whole base unit, for the hint: `0.3333333ms` -> `333333ns`.
Fault inexact(std::string_view text, std::string_view number, int exponent, const Kind& kind) {
  const std::size_t point = number.find('.');
  std::string digits(number.substr(0, point));
  digits += number.substr(point + 1, static_cast<std::size_t>(exponent));
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
  const std::string hint = digits.size() > 18 ? "" : fmt::format("write '{}{}'", digits, kind.base);
  return {code::quantity_inexact, fmt::format("'{}' is not a whole number of {}", shown(text), kind.base), hint};
}

Result<std::int64_t> exact(std::string_view text, const Kind& kind) {
  const Result<Parts> parts = split(text, kind);
  if (!parts) return parts.fault();
  const std::string_view number = (*parts).number;
  const std::size_t point = number.find('.');
  std::string_view fraction = point == std::string_view::npos ? std::string_view() : number.substr(point + 1);
  while (!fraction.empty() && fraction.back() == '0') fraction.remove_suffix(1);
  const int zeros = (*parts).exponent - static_cast<int>(fraction.size() > 99 ? 99 : fraction.size());
  if (zeros < 0) {
    return inexact(text, number, (*parts).exponent, kind);
  }
  std::int64_t value = 0;
  const bool fits = append_digits(value, number.substr(0, point)) && append_digits(value, fraction) &&
                    append_digits(value, std::string(static_cast<std::size_t>(zeros), '0'));
  if (!fits) return too_large(text);
  return value;
}

std::string in_largest_unit(std::int64_t value, std::string_view base) {
  if (value % 1'000'000 == 0) return fmt::format("{}M{}", value / 1'000'000, base);
  if (value % 1'000 == 0) return fmt::format("{}k{}", value / 1'000, base);
  return fmt::format("{}{}", value, base);
}

/// `500Hz` where a duration belongs -> `2ms`; `1MHz` where a bit rate does -> `1Mbit/s`: what was said, if it is exact
/// in a unit of the wanted kind. Empty when it is no quantity of a related kind.
std::string related(std::string_view number, std::string_view unit, const Kind& kind) {
  constexpr std::int64_t kNanoseconds = 1'000'000'000;
  for (const Kind* other : {&kDurationKind, &kFrequencyKind, &kBitrateKind}) {
    const bool is_theirs = std::any_of(other->units.begin(), other->units.end(),
                                       [&](const UnitName& name) { return equal_ignoring_case(name.text, unit); });
    if (!is_theirs || other->base == kind.base) continue;
    std::string written(number);
    for (const UnitName& name : other->units) {
      if (equal_ignoring_case(name.text, unit)) written += name.text;
    }
    const Result<std::int64_t> value = exact(written, *other);
    if (!value || *value == 0) return {};
    const bool inverts = (kind.base == "ns") != (other->base == "ns");
    if (inverts && kNanoseconds % *value != 0) return {};
    const std::int64_t meant = inverts ? kNanoseconds / *value : *value;
    if (kind.base == "ns") return format_duration(nanoseconds(meant));
    if (kind.base == "Hz" || kind.base == "bit/s") return in_largest_unit(meant, kind.base);
  }
  return {};
}

Fault other_unit(std::string_view number, std::string_view unit, const Kind& kind) {
  std::string hint = fmt::format("units are {}", unit_list(kind));
  for (const UnitName& candidate : kind.units) {
    if (equal_ignoring_case(unit, candidate.text))
      hint = fmt::format("units are case-sensitive: write '{}{}'", number, candidate.text);
  }
  const std::string_view foreign = meant_unit(unit, kind);
  const std::string meant = foreign.empty() ? related(number, unit, kind) : fmt::format("{}{}", number, foreign);
  if (!meant.empty()) hint = fmt::format("write '{}'; {}", meant, hint);
  return {code::unit_wrong, fmt::format("'{}' is not a unit of {}", shown(unit), kind.article_name), hint};
}

}  // namespace

Result<Duration> parse_duration(std::string_view text) {
  const Result<std::int64_t> ns = exact(text, kDurationKind);
  if (!ns) return ns.fault();
  return nanoseconds(*ns);
}

Result<std::int64_t> parse_frequency(std::string_view text) { return exact(text, kFrequencyKind); }
Result<std::int64_t> parse_bitrate(std::string_view text) { return exact(text, kBitrateKind); }
Result<std::int64_t> parse_bits(std::string_view text) { return exact(text, kBitsKind); }

Result<double> parse_percent(std::string_view text) {
  const Result<Parts> parts = split(text, kPercentKind);
  if (!parts) return parts.fault();
  const std::string scaled = std::string((*parts).number) + "e-2";
  double value = 0;
  const auto [end, error] = std::from_chars(scaled.data(), scaled.data() + scaled.size(), value);
  if (error != std::errc() || end != scaled.data() + scaled.size()) return too_large(text);
  return value;
}

namespace {

double in_base_unit(std::int64_t value) { return static_cast<double>(value); }
double in_base_unit(Duration value) { return static_cast<double>(value.ns()); }

/// In the largest unit that divides it.
std::string joined_duration(Duration time, std::string_view blank) {
  const std::int64_t ns = time.ns();
  if (ns % 1'000'000'000 == 0) return fmt::format("{}{}s", ns / 1'000'000'000, blank);
  if (ns % 1'000'000 == 0) return fmt::format("{}{}ms", ns / 1'000'000, blank);
  if (ns % 1'000 == 0) return fmt::format("{}{}us", ns / 1'000, blank);
  return fmt::format("{}{}ns", ns, blank);
}

}  // namespace

template <typename T>
Fault with_meant_unit(Fault fault, std::string_view text, std::initializer_list<std::string_view> preferred,
                      Result<T> (*parse)(std::string_view), double least, double most) {
  if (fault.code != code::unit_missing) return fault;
  const std::size_t units = fault.hint.find("units are ");
  const std::string rest = units == std::string::npos ? "" : fault.hint.substr(units);
  fault.hint = rest;
  for (const std::string_view unit : preferred) {
    const std::string candidate = std::string(text) + std::string(unit);
    const auto value = parse(candidate);
    if (!value || in_base_unit(*value) < least || in_base_unit(*value) > most) continue;
    fault.hint = fmt::format("write '{}'{}{}", shown(candidate), rest.empty() ? "" : "; ", rest);
    break;
  }
  return fault;
}

template Fault with_meant_unit(Fault, std::string_view, std::initializer_list<std::string_view>,
                               Result<std::int64_t> (*)(std::string_view), double, double);
template Fault with_meant_unit(Fault, std::string_view, std::initializer_list<std::string_view>,
                               Result<Duration> (*)(std::string_view), double, double);

std::string format_duration(Duration time) { return joined_duration(time, ""); }

std::string spaced_duration(Duration time) { return joined_duration(time, " "); }

std::string readable_duration(Duration time) {
  const std::int64_t ns = time.ns();
  struct Scale {
    std::int64_t ns;
    int digits;
    const char* name;
  };
  for (const Scale& scale : {Scale{1'000'000'000, 9, "s"}, Scale{1'000'000, 6, "ms"}, Scale{1'000, 3, "us"}}) {
    if (ns / scale.ns == 0) continue;
    if (ns % scale.ns == 0) return fmt::format("{}{}", ns / scale.ns, scale.name);
    std::string text = fmt::format("{}.{:0{}}", ns / scale.ns, ns % scale.ns, scale.digits);
    text.erase(text.find_last_not_of('0') + 1);
    return text + scale.name;
  }
  return format_duration(time);
}

}  // namespace finemote::gen::units
