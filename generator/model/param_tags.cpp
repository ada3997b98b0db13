// The <param> elements of one tag: FM3023 to FM3027, and FM3030 to FM3034 for quantities.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "generator/descriptor/read_param.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/reading.hpp"

namespace finemote::gen {
namespace {

/// The names of params that the tag does not give yet.
std::vector<std::string> free_names(const std::vector<ParamSpec>& specs, const xml::Node& tag) {
  std::vector<std::string> names;
  for (const ParamSpec& spec : specs) {
    const bool is_given = std::any_of(tag.children.begin(), tag.children.end(), [&](const xml::Node& child) {
      return child.is_element("param") && value_of(child, "name") == spec.name;
    });
    if (!is_given) names.push_back(spec.name);
  }
  return names;
}

void report_unknown(Diagnostic& finding, const std::vector<ParamSpec>& specs, const xml::Node& tag,
                    std::string_view name) {
  const std::vector<std::string> names = free_names(specs, tag);
  suggest(finding, name, names);
  if (!names.empty()) return;
  finding.note(specs.empty() ? "it takes no params" : "all params it takes are given").hint("remove the <param>");
}

std::optional<ParamValue> read_value(Diagnostics& diagnostics, const xml::Node& tag, const ParamSpec& spec,
                                     const std::string& owner) {
  const TextAt text = element_text(tag);
  auto parsed = parse_param(spec, text.text);
  if (parsed.index() == 0) return std::get<0>(parsed);
  const ParamFault& fault = std::get<1>(parsed);
  auto& finding =
      diagnostics.error(fault.code, text.at, fmt::format("param '{}' of {}: {}", spec.name, owner, fault.message));
  finding.underline(text.text.empty() ? tag.name.size() + 1 : text.text.size());
  if (!spec.summary.empty()) finding.note(fmt::format("{}: {}", spec.name, spec.summary));
  if (!fault.hint.empty()) finding.hint(fault.hint);
  return {};
}

std::string example_of(const ParamSpec& spec) {
  switch (spec.kind) {
    case ParamKind::boolean:
      return "true";
    case ParamKind::enumeration:
      return spec.values.empty() ? "..." : spec.values.front();
    case ParamKind::text:
      return "...";
    default:
      break;
  }
  if (!spec.values.empty()) return spec.values.front();
  return spec.unit == Unit::time_ns        ? "10ms"
         : spec.unit == Unit::frequency_hz ? "50Hz"
         : spec.unit == Unit::bit_rate     ? "115200baud"
                                           : "1";
}

/// Said of whichever of the two is given, of the upper one first.
void check_order(Diagnostics& diagnostics, const std::map<std::string, const xml::Node*>& given, const Param& upper,
                 const Param& lower, const std::string& owner) {
  if (number_of(upper.value) >= number_of(lower.value)) return;
  const Param &named = upper.given ? upper : lower, &other = upper.given ? lower : upper;
  if (!named.given) return;
  const TextAt text = element_text(*given.at(named.spec->name));
  diagnostics
      .error(code::param_range, text.at,
             fmt::format("param '{}' of {}: '{}' is {} '{}', which is {}{}", named.spec->name, owner, text.text,
                         upper.given ? "below" : "above", other.spec->name,
                         number_text(*other.spec, number_of(other.value)), other.given ? "" : " by default"))
      .underline(text.text.size())
      .note(fmt::format("{}: {}", upper.spec->name, upper.spec->summary))
      .note(fmt::format("{}: {}", lower.spec->name, lower.spec->summary));
}

void check_orders(Diagnostics& diagnostics, const std::map<std::string, const xml::Node*>& given,
                  const std::vector<Param>& params, const std::string& owner) {
  const auto is_known = [&](const Param& param) { return param.given || given.count(param.spec->name) == 0; };
  for (const Param& upper : params) {
    for (const Param& lower : params) {
      if (lower.spec->name == upper.spec->at_least && is_known(upper) && is_known(lower))
        check_order(diagnostics, given, upper, lower, owner);
    }
  }
}

}  // namespace

std::vector<Param> read_param_tags(Reading& reading, const xml::Node& tag, const std::vector<ParamSpec>& specs,
                                   const std::string& owner) {
  Diagnostics& diagnostics = reading.diagnostics;
  std::map<std::string, const xml::Node*> given;
  std::map<std::string, ParamValue> values;
  for (const xml::Node& child : tag.children) {
    if (!child.is_element("param")) continue;
    const xml::Attribute* name = child.attribute("name");
    if (name == nullptr) continue;
    const ParamSpec* spec = find_spec(specs, name->value);
    if (spec == nullptr) {
      auto& finding =
          at_value(diagnostics, code::unknown_param, *name, fmt::format("{} has no param '{}'", owner, name->value));
      report_unknown(finding, specs, tag, name->value);
      continue;
    }
    const auto [first, is_fresh] = given.emplace(name->value, &child);
    if (!is_fresh) {
      at_value(diagnostics, code::param_twice, *name,
               fmt::format("param '{}' of {} is given twice", name->value, owner))
          .note("the first use is here", first->second->at);
      continue;
    }
    if (auto value = read_value(diagnostics, child, *spec, owner)) values.emplace(name->value, *value);
  }
  std::vector<Param> params;
  for (const ParamSpec& spec : specs) {
    const auto found = values.find(spec.name);
    if (found != values.end()) {
      params.push_back({&spec, found->second, true});
    } else {
      params.push_back({&spec, spec.fallback.value_or(ParamValue(std::int64_t{0})), false});
      if (spec.fallback || given.count(spec.name) > 0) continue;
      at_tag(diagnostics, code::param_missing, tag, fmt::format("{} needs the param '{}'", owner, spec.name))
          .note(spec.summary.empty() ? "it has no default" : spec.summary)
          .hint(fmt::format("add for example <param name=\"{}\">{}</param>", spec.name, example_of(spec)));
    }
  }
  check_orders(diagnostics, given, params, owner);
  return params;
}

}  // namespace finemote::gen
