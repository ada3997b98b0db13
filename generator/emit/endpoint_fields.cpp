#include "generator/emit/endpoint_fields.hpp"

#include <algorithm>

#include "generator/emit/number.hpp"
#include "generator/emit/pin_fields.hpp"

namespace finemote::gen {
namespace {

/// An endpoint that is a value: `kind` is its section in templates/endpoint_class.mustache.
Data endpoint_of_kind(const char* kind) {
  Data data = argument_of_kind("endpoint");
  set_choice(data, {"is_pulses", "is_level", "is_edge", "is_analog"}, kind);
  return data;
}

Data name_argument(const std::string& name) {
  Data data = argument_of_kind("name");
  data.set("name", name);
  return data;
}

Data level_pin(const std::string& pin, const NamedPin* named) {
  Data data = endpoint_of_kind("is_level");
  set_pin(pin, data);
  data.set("is_active_low", named != nullptr && named->active_low);
  return data;
}

Data analog_pin(const NamedPin& pin) {
  Data data = endpoint_of_kind("is_analog");
  data.set("converter", pin.converter);
  data.set("input", std::to_string(pin.input));
  data.set("full_scale", float_literal(static_cast<double>(pin.full_scale_mv) / 1000));
  return data;
}

/// A pin that a device uses by its name.
Data used_pin(const Use& use) {
  if (use.spec->function == "analog") return analog_pin(*use.named);
  if (use.spec->function != "interrupt") return level_pin(use.pin, use.named);
  Data data = endpoint_of_kind("is_edge");
  set_pin(use.pin, data);
  return data;
}

Data pulse_channel(const std::string& bus, std::uint32_t channel) {
  Data data = endpoint_of_kind("is_pulses");
  data.set("bus", bus);
  data.set("channel", std::to_string(channel));
  return data;
}

/// How a device reaches a bus or a channel of it.
std::optional<Data> on_segment(const Plan& plan, const Scope& scope, const Segment& segment, const std::string& slot,
                               std::uint32_t channel) {
  switch (segment.bus_kind) {
    case BusKind::uart:
      return name_argument(scope.of_robot(segment.name.cpp));
    case BusKind::pwm:
      return pulse_channel(scope.of_robot(segment.name.cpp), channel);
    case BusKind::gpio: {  // its pins are those of the board file, in its order
      const NamedPin& pin = plan.robot.board->pins.at(channel);
      return level_pin(pin.pin, &pin);
    }
    case BusKind::virtual_bus:
      return std::nullopt;
    case BusKind::rs485:
    case BusKind::i2c:
    case BusKind::spi:
    case BusKind::can:
      break;
  }
  return name_argument(scope.of_robot("slots::" + slot));
}

std::optional<Data> used(const Plan& plan, const Scope& scope, const Device& device, const Use& use) {
  if (!use.segment) return used_pin(use);
  return on_segment(plan, scope, plan.robot.segments[*use.segment], device.name.cpp + "_" + use.spec->role,
                    use.channel.value_or(0));
}

/// Whether the endpoint is a value, not an object that stands elsewhere.
bool is_value(const Plan& plan, const Use& use) {
  if (!use.segment) return true;
  const BusKind kind = plan.robot.segments[*use.segment].bus_kind;
  return kind == BusKind::pwm || kind == BusKind::gpio;
}

std::string object_name(const Device& device, const UseSpec& spec) { return device.name.cpp + "_use_" + spec.role; }

}  // namespace

Data argument_of_kind(const std::string& kind) {
  Data data;
  set_choice(data, {"is_config", "is_nothing", "is_name", "is_address", "is_endpoint", "is_port", "is_no_port"},
             "is_" + kind);
  data.set("has_role", false);
  return data;
}

std::optional<Data> bus_argument(const Plan& plan, const Scope& scope, const Device& device) {
  if (!device.segment) return std::nullopt;
  return on_segment(plan, scope, plan.robot.segments[*device.segment], device.name.cpp, device.channel.value_or(0));
}

std::optional<Data> use_argument(const Plan& plan, const Scope& scope, const Device& device, const UseSpec& spec) {
  const auto use = std::find_if(device.uses.begin(), device.uses.end(),
                                [&](const Use& candidate) { return candidate.spec == &spec; });
  std::optional<Data> argument;
  if (use == device.uses.end()) {
    argument = argument_of_kind("nothing");
  } else if (!spec.required && is_value(plan, *use)) {
    argument = argument_of_kind("address");
    argument->set("name", "ports::" + object_name(device, spec));
  } else {
    argument = used(plan, scope, device, *use);
    if (argument && !spec.required) set_choice(*argument, {"is_name", "is_address"}, "is_address");
  }
  if (!argument) return std::nullopt;
  argument->set("has_role", true);
  argument->set("role", spec.role);
  return argument;
}

Data endpoint_objects(const Plan& plan, const Scope& scope, const Device& device) {
  Data list(Data::type::list);
  for (const Use& use : device.uses) {
    if (use.spec->required || !is_value(plan, use)) continue;
    Data entry = *used(plan, scope, device, use);
    entry.set("object", object_name(device, *use.spec));
    list.push_back(entry);
  }
  return list;
}

}  // namespace finemote::gen
