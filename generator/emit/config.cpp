#include "generator/emit/config.hpp"

#include "generator/diagnostic/printable.hpp"
#include "generator/emit/names.hpp"
#include "generator/emit/value.hpp"

namespace finemote::gen {
namespace {

/// Members that share a line: how many at most, and how wide their names and values are.
constexpr std::size_t kMostInLine = 2, kWidestInLine = 55;

bool is_assigned(const Param& param, bool is_shipped) {
  const bool is_default = param.spec->fallback && *param.spec->fallback == param.value;
  return !is_shipped || !is_default;
}

/// What the value does not say of itself; durations do.
std::string unit_of(const ParamSpec& spec) {
  return spec.unit == Unit::time_ns ? std::string() : printable(spec.unit_text);
}

}  // namespace

void set_config(const std::string& cpp_class, const std::vector<Param>& params, bool is_shipped, Data& data) {
  Data members(Data::type::list);
  std::size_t width = 0;
  for (const Param& param : params) {
    if (!is_assigned(param, is_shipped)) continue;
    const std::string value = value_expression(*param.spec, param.value), unit = unit_of(*param.spec);
    width += param.spec->name.size() + value.size();
    Data member;
    member.set("member", param.spec->name);
    member.set("value", value);
    member.set("is_exact", !is_shipped);
    member.set("has_unit", !unit.empty());
    member.set("unit", unit);
    members.push_back(member);
  }
  const bool share_line = is_shipped && members.list_value().size() <= kMostInLine && width <= kWidestInLine;
  data.set("class", class_name(cpp_class));
  set_choice(data, {"is_default", "is_in_line", "is_in_lines"},
             members.is_empty_list() ? "is_default"
             : share_line            ? "is_in_line"
                                     : "is_in_lines");
  data.set("members", members);
}

}  // namespace finemote::gen
