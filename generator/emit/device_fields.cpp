#include "generator/emit/device_fields.hpp"

#include <algorithm>

#include "generator/emit/config.hpp"
#include "generator/emit/endpoint_fields.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

/// Sets what templates/port.mustache names, as seen from `scope`.
void set_port(const Plan& plan, const Scope& scope, DeviceId owner, const RoleBinding& role, const Binding& binding,
              Data& data) {
  const std::string target = scope.device(binding.device);
  const auto crossed = [&](std::size_t crossing) { return scope.port(owner, plan.schedule.crossings[crossing].name); };
  data.set("interface", class_name(role.interface));
  data.set("state", binding.state_crossing ? crossed(*binding.state_crossing) : target + "." + binding.state_member);
  data.set("has_command", binding.has_command);
  data.set("command", binding.command_crossing ? crossed(*binding.command_crossing)
                      : binding.sink           ? scope.port(owner, binding.sink_name)
                                               : target + "." + binding.command_member);
}

Data crossing_list(const Plan& plan, DeviceId home) {
  Data list(Data::type::list);
  for (const Crossing& crossing : plan.schedule.crossings) {
    if (crossing.home != home) continue;
    const Device &producer = plan.robot.devices[crossing.producer], &consumer = plan.robot.devices[crossing.consumer];
    Data entry;
    entry.set("is_state", crossing.direction == Crossing::Direction::state);
    entry.set("is_copy", crossing.kind == Crossing::Kind::copy);
    entry.set("is_to_slow", crossing.kind == Crossing::Kind::to_slow);
    entry.set("is_to_fast", crossing.kind == Crossing::Kind::to_fast);
    entry.set("type", class_name(crossing.type));
    entry.set("port", crossing.name);
    entry.set("producer", producer.name.text);
    entry.set("producer_period", units::spaced_duration(producer.period));
    entry.set("consumer", consumer.name.text);
    entry.set("consumer_period", units::spaced_duration(consumer.period));
    list.push_back(entry);
  }
  return list;
}

Data role_fields(const Plan& plan, const Scope& scope, DeviceId device, const RoleBinding& role) {
  Data data, sinks(Data::type::list), bindings(Data::type::list);
  for (const Binding& binding : role.bindings) {
    if (binding.sink) sinks.push_back(Data("sink", binding.sink_name));
    Data port;
    set_port(plan, scope.ports(), device, role, binding, port);
    bindings.push_back(port);
  }
  data.set("interface", class_name(role.interface));
  data.set("sinks", sinks);
  data.set("has_array", !role.array.empty());
  data.set("array", role.array);
  data.set("bindings", bindings);
  return data;
}

Data constant_argument(const Device& device, const Scope& scope, const Constant& constant) {
  if (constant.exists()) {
    Data argument = argument_of_kind("name");
    argument.set("name", constant.in_tree ? "ports::" + constant.name : scope.of_robot("constants::" + constant.name));
    return argument;
  }
  Data argument = argument_of_kind("nothing");
  argument.set("has_role", true);
  argument.set("role", constant.name.substr(device.name.cpp.size() + 1));
  return argument;
}

Data role_argument(const Plan& plan, const Scope& scope, DeviceId device, const RoleBinding& role) {
  if (role.single && !role.bindings.empty()) {
    Data argument = argument_of_kind("port");
    set_port(plan, scope, device, role, role.bindings.front(), argument);
    return argument;
  }
  Data argument = argument_of_kind(role.array.empty() ? "no_port" : "name");
  argument.set("interface", class_name(role.interface));
  argument.set("name", "ports::" + role.array);
  return argument;
}

DataList arguments_of(const Plan& plan, const Scope& scope, DeviceId index, const std::vector<Constant>& constants) {
  const Device& device = plan.robot.devices[index];
  DataList arguments;
  arguments.reserve(4 + device.type->uses.size() + plan.schedule.roles[index].size());
  if (!device.params.empty()) {
    arguments.push_back(argument_of_kind("config"));
    set_config(device.type->cpp_class, device.params, device.type->builtin, arguments.back());
  }
  for (const Constant& constant : constants) {
    if (constant.device == index) arguments.push_back(constant_argument(device, scope, constant));
  }
  if (const auto argument = bus_argument(plan, scope, device)) arguments.push_back(*argument);
  for (const UseSpec& spec : device.type->uses) {
    if (const auto argument = use_argument(plan, scope, device, spec)) arguments.push_back(*argument);
  }
  for (const RoleBinding& role : plan.schedule.roles[index])
    arguments.push_back(role_argument(plan, scope, index, role));
  return arguments;
}

}  // namespace

void set_device(const Plan& plan, const Scope& scope, DeviceId index, const std::vector<Constant>& constants,
                Data& data) {
  const Device& device = plan.robot.devices[index];
  data.set("device", device.name.cpp);
  data.set("class", class_name(device.type->cpp_class));
  data.set("is_constant", device.type->constant_init);
  data.set("arguments", enumerated(arguments_of(plan, scope, index, constants)));
}

void set_ports(const Plan& plan, const Scope& scope, DeviceId index, const std::vector<Constant>& constants,
               Data& data) {
  const Data crossings = crossing_list(plan, index);
  const Data endpoints = endpoint_objects(plan, scope.ports(), plan.robot.devices[index]);
  Data roles(Data::type::list), links(Data::type::list);
  bool has_roles = false;
  for (const RoleBinding& role : plan.schedule.roles[index]) {
    has_roles = has_roles || !role.array.empty() ||
                std::any_of(role.bindings.begin(), role.bindings.end(), [](const Binding& b) { return b.sink; });
    roles.push_back(role_fields(plan, scope, index, role));
  }
  for (const Constant& constant : constants) {
    if (constant.device == index && constant.in_tree) links.push_back(*constant.fields);
  }
  data.set("has_ports",
           has_roles || !crossings.is_empty_list() || !endpoints.is_empty_list() || !links.is_empty_list());
  data.set("crossings", crossings);
  data.set("endpoints", endpoints);
  data.set("roles", roles);
  data.set("links", links);
}

}  // namespace finemote::gen
