#include "generator/emit/device_definition.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/bus/bus_type.hpp"
#include "generator/emit/config.hpp"
#include "generator/emit/number.hpp"
#include "generator/schedule/period.hpp"

namespace finemote::gen {
namespace {

constexpr std::size_t kWidest = 118;

std::string join(const std::vector<std::string>& parts, const std::string& separator) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) text += (i > 0 ? separator : "") + parts[i];
  return text;
}

std::string level_pin(const std::string& pin, const NamedPin* named) {
  const bool active_low = named != nullptr && named->active_low;
  return fmt::format("finemote::GpioPin{{finemote::ports::gpio, {}{}}}", pin_number(pin),
                     active_low ? ", /*active low*/ true" : "");
}

/// The pins of a gpio bus are those of the board file, in its order.
std::string pin_on_bus(const Plan& plan, std::uint32_t channel) {
  const NamedPin& pin = plan.robot.board->pins.at(channel);
  return level_pin(pin.pin, &pin);
}

/// A pin that a device uses by its name.
std::string used_pin(const Use& use) {
  if (use.spec->function == "interrupt")
    return fmt::format("finemote::EdgePin{{finemote::ports::exti{}}}", use.pin.substr(2));
  if (use.spec->function != "analog") return level_pin(use.pin, use.named);
  return fmt::format("finemote::AnalogPin{{finemote::ports::{}, /*input*/ {}, /*full scale [V]*/ {}}}",
                     use.named->converter, use.named->input,
                     float_literal(static_cast<double>(use.named->full_scale_mv) / 1000));
}

/// The C++ class of an endpoint that is a value; empty for those that are objects elsewhere.
std::string value_class(const Plan& plan, const Use& use) {
  if (!use.segment) {
    return use.spec->function == "interrupt" ? "finemote::EdgePin"
           : use.spec->function == "analog"  ? "finemote::AnalogPin"
                                             : "finemote::GpioPin";
  }
  const BusType::Reach reach = bus_type(plan.robot.segments[*use.segment].bus_kind).reach;
  return reach == BusType::Reach::channel ? "finemote::PwmChannel"
         : reach == BusType::Reach::pin   ? "finemote::GpioPin"
                                          : "";
}

/// How a device reaches a bus or a channel of it.
std::string endpoint(const Plan& plan, const Segment& segment, const std::string& slot, std::uint32_t channel) {
  const std::string bus = bus_reference(plan, segment.name.cpp);
  switch (bus_type(segment.bus_kind).reach) {
    case BusType::Reach::slot:
      return bus_reference(plan, "slots::" + slot);
    case BusType::Reach::bus:
      return bus;
    case BusType::Reach::channel:
      return fmt::format("finemote::PwmChannel{{{}, {}}}", bus, channel);
    case BusType::Reach::pin:
      return pin_on_bus(plan, channel);
    case BusType::Reach::nothing:
      break;
  }
  return {};
}

std::string use_endpoint(const Plan& plan, const Device& device, const Use& use) {
  if (!use.segment) return used_pin(use);
  return endpoint(plan, plan.robot.segments[*use.segment], device.name.cpp + "_" + use.spec->role,
                  use.channel.value_or(0));
}

/// The name, in `ports`, of the object that stands for an optional value endpoint: a pointer needs something to point
/// to.
std::string use_object(const Device& device, const UseSpec& spec) { return device.name.cpp + "_use_" + spec.role; }

void add_use_objects(const Plan& plan, const Device& device, std::vector<std::string>& lines) {
  for (const Use& use : device.uses) {
    const std::string type = value_class(plan, use);
    if (use.spec->required || type.empty()) continue;
    const std::string value = use_endpoint(plan, device, use);
    lines.push_back(fmt::format("FINEMOTE_CONSTINIT inline {} {}{};", type, use_object(device, *use.spec),
                                value.substr(type.size())));
  }
}

void add_endpoints(const Plan& plan, const Device& device, std::vector<std::string>& arguments) {
  const auto add = [&](std::string text) {
    if (!text.empty()) arguments.push_back(std::move(text));
  };
  if (device.segment) {
    add(endpoint(plan, plan.robot.segments[*device.segment], device.name.cpp, device.channel.value_or(0)));
  }
  for (const UseSpec& spec : device.type->uses) {
    const auto use = std::find_if(device.uses.begin(), device.uses.end(),
                                  [&](const Use& candidate) { return candidate.spec == &spec; });
    if (use == device.uses.end()) {
      arguments.push_back(fmt::format("/*{}*/ nullptr", spec.role));
    } else if (!spec.required && !value_class(plan, *use).empty()) {
      add(fmt::format("/*{}*/ &ports::{}", spec.role, use_object(device, spec)));
    } else {
      add(fmt::format("/*{}*/ {}{}", spec.role, spec.required ? "" : "&", use_endpoint(plan, device, *use)));
    }
  }
}

std::string port(const Plan& plan, DeviceId owner, const RoleBinding& role, const Binding& binding, bool inside_ports) {
  const std::string ports = inside_ports ? "" : "ports::";
  const std::string target = device_reference(plan, owner, binding.device);
  const std::string state = binding.state_crossing ? ports + plan.schedule.crossings[*binding.state_crossing].name
                                                   : target + "." + binding.state_member;
  std::string text = state;
  if (binding.has_command) {
    std::string command = target + "." + binding.command_member;
    if (binding.sink) command = ports + binding.sink_name;
    if (binding.command_crossing) command = ports + plan.schedule.crossings[*binding.command_crossing].name;
    text += ", " + command;
  }
  return fmt::format("finemote::Port<{}>{{{}}}", role.interface, text);
}

std::string period_of(const Plan& plan, DeviceId device) { return period_text(plan.robot.devices[device].period_ns); }

std::string crossing_comment(const Plan& plan, const Crossing& crossing) {
  const auto& devices = plan.robot.devices;
  return fmt::format("// {}: {} ({}) -> {} ({})",
                     crossing.direction == Crossing::Direction::state ? "state" : "command",
                     devices[crossing.producer].name.text, period_of(plan, crossing.producer),
                     devices[crossing.consumer].name.text, period_of(plan, crossing.consumer));
}

void add_crossings(const Plan& plan, DeviceId device, std::vector<std::string>& lines) {
  for (const Crossing& crossing : plan.schedule.crossings) {
    if (crossing.home != device) continue;
    lines.push_back(crossing_comment(plan, crossing));
    if (crossing.kind != Crossing::Kind::copy) {
      const char* latch = crossing.kind == Crossing::Kind::to_slow ? "LatchToSlow" : "LatchToFast";
      lines.push_back(
          fmt::format("FINEMOTE_CONSTINIT inline finemote::{}<{}> {}_latch{{}};", latch, crossing.type, crossing.name));
    } else {
      lines.push_back(fmt::format("static_assert(finemote::CheckedCrossing<{}>::ok);", crossing.type));
    }
    lines.push_back(fmt::format("FINEMOTE_CONSTINIT inline {} {}{{}};", crossing.type, crossing.name));
  }
}

void add_sinks(const RoleBinding& role, std::vector<std::string>& lines) {
  for (const Binding& binding : role.bindings) {
    if (!binding.sink) continue;
    lines.push_back(fmt::format("FINEMOTE_CONSTINIT inline {}::Command {}{{}};  // goes nowhere", role.interface,
                                binding.sink_name));
  }
}

void add_array(const Plan& plan, DeviceId device, const RoleBinding& role, std::vector<std::string>& lines) {
  if (role.array.empty()) return;
  lines.push_back(fmt::format("inline constexpr finemote::Port<{}> {}[] = {{", role.interface, role.array));
  for (const Binding& binding : role.bindings) lines.push_back("    " + port(plan, device, role, binding, true) + ",");
  lines.push_back("};");
}

}  // namespace

std::vector<std::string> port_lines(const Plan& plan, DeviceId device) {
  std::vector<std::string> lines;
  add_crossings(plan, device, lines);
  add_use_objects(plan, plan.robot.devices[device], lines);
  for (const RoleBinding& role : plan.schedule.roles[device]) {
    add_sinks(role, lines);
    add_array(plan, device, role, lines);
  }
  return lines;
}

std::string device_definition(const Plan& plan, DeviceId index, const std::vector<Constant>& constants) {
  const Device& device = plan.robot.devices[index];
  std::vector<std::string> arguments;
  if (!device.params.empty())
    arguments.push_back(config_expression(device.type->cpp_class, device.params, device.type->builtin));
  for (const Constant& constant : constants) {
    if (constant.device != index) continue;
    if (constant.text.empty()) {
      arguments.push_back(fmt::format("/*{}*/ nullptr", constant.name.substr(device.name.cpp.size() + 1)));
      continue;
    }
    arguments.push_back(constant.in_tree ? "ports::" + constant.name
                                         : bus_reference(plan, "constants::" + constant.name));
  }
  add_endpoints(plan, device, arguments);
  for (const RoleBinding& role : plan.schedule.roles[index]) {
    if (role.single && !role.bindings.empty()) {
      arguments.push_back(port(plan, index, role, role.bindings.front(), false));
    } else {
      arguments.push_back(role.array.empty() ? fmt::format("finemote::Ports<{}>{{}}", role.interface)
                                             : "ports::" + role.array);
    }
  }
  const std::string type = device.type->constant_init ? device.type->cpp_class
                                                      : fmt::format("finemote::Ordered<{}>", device.type->cpp_class);
  const char* qualifier = device.type->constant_init ? "FINEMOTE_CONSTINIT inline" : "inline";
  const std::string line = fmt::format("{} {} {}{{{}}};", qualifier, type, device.name.cpp, join(arguments, ", "));
  if (line.size() <= kWidest && line.find('\n') == std::string::npos) return line;
  return fmt::format("{} {} {}{{\n    {}}};", qualifier, type, device.name.cpp, join(arguments, ",\n    "));
}

}  // namespace finemote::gen
