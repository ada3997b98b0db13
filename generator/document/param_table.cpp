#include "generator/document/param_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "generator/document/markdown.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

std::string as_written(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

std::string range_text(const Json& param) {
  std::vector<std::string> values;
  for (const Json& value : param.value("values", Json::array())) values.push_back("`" + as_written(value) + "`");
  if (!values.empty()) return joined(values);
  const auto range = param.find("range");
  return range == param.end() ? "" : fmt::format("`{}`..`{}`", as_written(range->at(0)), as_written(range->at(1)));
}

std::string param_row(const Json& param) {
  static const std::vector<std::string> exact{"ns", "Hz", "bit/s", "bit", "%"};
  std::string meaning = param.value("summary", "");
  const std::string unit = param.value("unit", "");
  if (!unit.empty() && std::find(exact.begin(), exact.end(), unit) == exact.end()) meaning += " [" + unit + "]";
  if (param.value("limits", "") == "command_age") meaning += "; lint compares it with the proven age";
  if (param.contains("at_least")) meaning += fmt::format("; at least `{}`", param["at_least"].get<std::string>());
  return row({"`" + param["name"].get<std::string>() + "`",
              param.contains("default") ? "`" + as_written(param["default"]) + "`" : "required", range_text(param),
              meaning});
}

}  // namespace

std::string param_table(const Json& owner) {
  const auto params = owner.find("params");
  if (params == owner.end() || !params->is_array() || params->empty()) return {};
  std::string text = "\n## Parameters\n\n" + table({"name", "default", "range", "meaning"});
  for (const Json& param : *params) text += param_row(param);
  return text;
}

}  // namespace finemote::gen
