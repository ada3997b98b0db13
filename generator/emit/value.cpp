#include "generator/emit/value.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>

#include "generator/diagnostic/printable.hpp"
#include "generator/emit/number.hpp"

namespace finemote::gen {
namespace {

std::string integer_expression(const ParamSpec& spec, std::int64_t value) {
  if (spec.kind == ParamKind::real) return given_float_literal(static_cast<double>(value));
  if (spec.unit == Unit::time_ns) return duration_expression(nanoseconds(value));
  if (spec.unit != Unit::none) return fmt::format("std::int64_t{{{}}}", value);
  // Read as a sign before a number that does not fit, the lowest one would be wider than the others.
  return value == std::numeric_limits<std::int32_t>::min() ? "-2147483647 - 1" : std::to_string(value);
}

std::string text_expression(const ParamSpec& spec, const std::string& value) {
  if (spec.kind != ParamKind::enumeration) return string_literal(value);
  const auto found = spec.enumerators.find(value);
  return found == spec.enumerators.end() ? string_literal(value) : found->second;
}

}  // namespace

std::string duration_expression(Duration time) {
  struct Named {
    Duration length;
    const char* name;
  };
  constexpr std::array kUnits{Named{seconds(1), "kSecond"}, Named{milliseconds(1), "kMillisecond"},
                              Named{microseconds(1), "kMicrosecond"}};
  for (const auto& [length, name] : kUnits) {
    if (time != Duration::zero() && is_multiple(time, length))
      return fmt::format("{} * finemote::{}", floor_div(time, length), name);
  }
  return fmt::format("finemote::Duration{{{}}}", time.ns());
}

std::string string_literal(const std::string& text) {
  const std::string shown = printable(text);  // a `?` for each byte that is not
  std::string literal = "\"";
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool is_trigraph = c == '?' && i > 0 && text[i - 1] == '?';
    if (c == '"' || c == '\\' || is_trigraph) {
      literal += std::string("\\") + c;
    } else if (c == '\t' || shown[i] != c) {
      literal += fmt::format("\\{:03o}", static_cast<unsigned char>(c));
    } else {
      literal += c;
    }
  }
  return literal + "\"";
}

std::string value_expression(const ParamSpec& spec, const ParamValue& value) {
  struct {
    const ParamSpec& spec;
    std::string operator()(std::int64_t value) const { return integer_expression(spec, value); }
    std::string operator()(double value) const { return given_float_literal(value); }
    std::string operator()(bool value) const { return value ? "true" : "false"; }
    std::string operator()(const std::string& value) const { return text_expression(spec, value); }
  } visitor{spec};
  return std::visit(visitor, value);
}

}  // namespace finemote::gen
