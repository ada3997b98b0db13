#include "generator/document/param_table.hpp"

#include <fmt/format.h>

#include "generator/descriptor/read_param.hpp"
#include "generator/document/markdown.hpp"

namespace finemote::gen {
namespace {

/// As the URDF writes it.
std::string as_written(const ParamSpec& spec, const ParamValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  return number_text(spec, number_of(value));
}

std::string range_text(const ParamSpec& spec) {
  std::vector<std::string> values;
  for (const std::string& value : spec.values) values.push_back("`" + value + "`");
  if (!values.empty()) return joined(values);
  if (!spec.min || !spec.max) return "";
  return fmt::format("`{}`..`{}`", number_text(spec, *spec.min), number_text(spec, *spec.max));
}

std::string param_row(const ParamSpec& spec) {
  std::string meaning = spec.summary;
  if (spec.unit == Unit::none && !spec.unit_text.empty()) meaning += " [" + spec.unit_text + "]";
  if (spec.limits_command_age) meaning += "; lint compares it with the proven age";
  if (!spec.at_least.empty()) meaning += fmt::format("; at least `{}`", spec.at_least);
  return row({"`" + spec.name + "`", spec.fallback ? "`" + as_written(spec, *spec.fallback) + "`" : "required",
              range_text(spec), meaning});
}

}  // namespace

std::string param_table(const std::vector<ParamSpec>& params) {
  if (params.empty()) return {};
  std::string text = "\n## Parameters\n\n" + table({"name", "default", "range", "meaning"});
  for (const ParamSpec& param : params) text += param_row(param);
  return text;
}

}  // namespace finemote::gen
