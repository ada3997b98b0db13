#include "generator/emit/config.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <limits>

#include "generator/diagnostic/printable.hpp"
#include "generator/emit/names.hpp"
#include "generator/emit/number.hpp"

namespace finemote::gen {
namespace {

/// `20 * finemote::kMillisecond`: in the largest unit that divides it.
std::string duration_expression(std::int64_t ns) {
  struct Named {
    std::int64_t ns;
    const char* name;
  };
  constexpr std::array kUnits{Named{1'000'000'000, "kSecond"}, Named{1'000'000, "kMillisecond"},
                              Named{1'000, "kMicrosecond"}};
  for (const Named& unit : kUnits) {
    if (ns != 0 && ns % unit.ns == 0) return fmt::format("{} * finemote::{}", ns / unit.ns, unit.name);
  }
  return fmt::format("finemote::Duration{{{}}}", ns);
}

std::string integer_expression(const ParamSpec& spec, std::int64_t value) {
  if (spec.kind == ParamKind::real) return given_float_literal(static_cast<double>(value));
  if (spec.unit == Unit::time_ns) return duration_expression(value);
  if (spec.unit != Unit::none) return fmt::format("std::int64_t{{{}}}", value);
  // Read as a sign before a number that does not fit, the lowest one would be wider than the others.
  return value == std::numeric_limits<std::int32_t>::min() ? "-2147483647 - 1" : std::to_string(value);
}

std::string text_expression(const ParamSpec& spec, const std::string& value) {
  if (spec.kind != ParamKind::enumeration) return string_literal(value);
  const auto found = spec.enumerators.find(value);
  return found == spec.enumerators.end() ? string_literal(value) : found->second;
}

/// `  // [Hz]` behind an assignment that does not say its unit.
std::string unit_comment(const ParamSpec& spec) {
  return spec.unit == Unit::time_ns || spec.unit_text.empty() ? "" : "  // [" + printable(spec.unit_text) + "]";
}

std::vector<const Param*> assigned(const std::vector<Param>& params, bool is_shipped) {
  std::vector<const Param*> result;
  for (const Param& param : params) {
    const bool is_default = param.spec->fallback && *param.spec->fallback == param.value;
    if (!is_shipped || !is_default) result.push_back(&param);
  }
  return result;
}

std::string assignment(const Param& param, bool is_shipped) {
  const std::string& name = param.spec->name;
  const std::string value = value_expression(*param.spec, param.value);
  return is_shipped ? fmt::format("c.{} = {};", name, value)
                    : fmt::format("c.{0} = finemote::exact<decltype(c.{0})>({1});", name, value);
}

}  // namespace

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

std::string config_expression(const std::string& cpp_class, const std::vector<Param>& params, bool is_shipped) {
  constexpr std::size_t kWidest = 110;
  const std::vector<const Param*> members = assigned(params, is_shipped);
  if (members.empty()) return cpp_class + "::Config{}";
  std::string statements, lines;
  for (const Param* param : members) {
    const std::string statement = assignment(*param, is_shipped);
    statements += " " + statement;
    lines += "      " + statement + unit_comment(*param->spec) + "\n";
  }
  const std::string short_form = fmt::format("[] {{ {}::Config c{{}};{} return c; }}()", cpp_class, statements);
  if (is_shipped && short_form.size() <= kWidest) return short_form;
  return fmt::format("[] {{\n      {}::Config c{{}};\n{}      return c;\n    }}()", cpp_class, lines);
}

}  // namespace finemote::gen
