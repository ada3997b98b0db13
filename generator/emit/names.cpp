#include "generator/emit/names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/diagnostic/printable.hpp"

namespace finemote::gen {
namespace {

std::string tree_space(const Plan& plan, DeviceId device) {
  const Tree& tree = plan.forest.trees[plan.forest.tree_of[device]];
  return fmt::format("::{}::{}", plan.robot.name.cpp, tree.space);
}

bool same_tree(const Plan& plan, DeviceId a, DeviceId b) { return plan.forest.tree_of[a] == plan.forest.tree_of[b]; }

}  // namespace

std::string bus_reference(const Plan& plan, const std::string& cpp_name) {
  return fmt::format("::{}::{}", plan.robot.name.cpp, cpp_name);
}

std::string ports_prefix(const Plan& plan, DeviceId from, DeviceId home) {
  return same_tree(plan, from, home) ? "ports::" : tree_space(plan, home) + "::ports::";
}

std::string device_reference(const Plan& plan, DeviceId from, DeviceId device) {
  const std::string& name = plan.robot.devices[device].name.cpp;
  return same_tree(plan, from, device) ? name : tree_space(plan, device) + "::" + name;
}

std::string pin_number(const std::string& pin) {
  return fmt::format("finemote::pin_number('{}', {})", pin.at(1), pin.substr(2));
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

std::string device_comment(const Plan& plan, DeviceId device) {
  const Device& d = plan.robot.devices[device];
  if (!d.segment) return d.type->name;
  const Segment& segment = plan.robot.segments[*d.segment];
  std::string text = fmt::format("{} on '{}'", d.type->name, segment.name.text);
  if (d.address) text += fmt::format(" at {:#04x}", *d.address);
  if (d.channel) text += fmt::format(" channel {}", *d.channel);
  if (d.id) text += fmt::format(" id {}", *d.id);
  return text;
}

Data common_data(const Plan& plan) {
  Data data;
  data.set("source", printable(plan.robot.source));
  data.set("robot", plan.robot.name.text);
  data.set("robot_literal", string_literal(plan.robot.name.text));
  data.set("robot_space", plan.robot.name.cpp);
  return data;
}

Data include_list(std::vector<std::string> includes) {
  std::sort(includes.begin(), includes.end(), [](const std::string& a, const std::string& b) {
    const bool a_system = a.front() == '<';
    const bool b_system = b.front() == '<';
    return a_system != b_system ? a_system : a < b;
  });
  includes.erase(std::unique(includes.begin(), includes.end()), includes.end());
  Data list(Data::type::list);
  for (const std::string& include : includes) list.push_back(Data("include", include));
  return list;
}

}  // namespace finemote::gen
