#include "generator/emit/names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/diagnostic/printable.hpp"
#include "generator/emit/value.hpp"

namespace finemote::gen {
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

std::string class_name(const std::string& qualified) {
  return qualified.starts_with("finemote::") ? qualified : "::" + qualified;
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
