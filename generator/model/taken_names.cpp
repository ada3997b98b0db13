#include "generator/model/taken_names.hpp"

#include <fmt/format.h>

#include "generator/model/names.hpp"

namespace finemote::gen {

TakenNames::TakenNames(const Robot& robot) : robot_(robot.name.cpp) {
  for (const Device& device : robot.devices) {
    if (device.type == nullptr || device.type->builtin) continue;
    const DeviceType& type = *device.type;
    add(type.cpp_class, "class", type.name);
    for (const Interface& interface : type.provides) add(interface.cpp, "interface", type.name);
    for (const RoleSpec& role : type.roles) add(role.interface, "interface", type.name);
    add_params(type.params, type.name);
  }
  for (const Expander& expander : robot.expanders) {
    if (expander.type == nullptr || expander.type->builtin) continue;
    add(expander.type->cpp_class, "class", expander.type->name);
    add_params(expander.type->params, expander.type->name);
  }
}

std::string TakenNames::in_robot(std::string_view cpp) const {
  const auto found = inside_.find(cpp);
  return found == inside_.end() ? std::string() : found->second;
}

void TakenNames::add_params(const std::vector<ParamSpec>& params, const std::string& type) {
  for (const ParamSpec& param : params) {
    for (const auto& [spelling, enumerator] : param.enumerators) add(enumerator, "enumerator", type);
  }
}

void TakenNames::add(const std::string& qualified, const char* what, const std::string& type) {
  const std::size_t end = std::min(qualified.find("::"), qualified.size());
  if (qualified.substr(0, end) != robot_) return;
  const std::string described = fmt::format("the {} '{}' of type '{}'", what, qualified, type);
  if (end == qualified.size()) {
    robot_taken_ = described;
    return;
  }
  const std::string rest = qualified.substr(end + 2);
  const std::string name = rest.substr(0, rest.find("::"));
  inside_.emplace(name, described);
  if (reserved_name(name, NameScope::in_robot)) robot_taken_ = described;
}

}  // namespace finemote::gen
