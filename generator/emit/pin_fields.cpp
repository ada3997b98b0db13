#include "generator/emit/pin_fields.hpp"

#include "generator/bus/bus_type.hpp"
#include "generator/descriptor/pin_name.hpp"

namespace finemote::gen {
namespace {

bool is_active_low(const NamedPin* named) { return named != nullptr && named->active_low; }

/// How a level pin comes up: idle is inactive.
const char* setting_of(const NamedPin* named, bool is_output) {
  if (is_output) return is_active_low(named) ? "kOutputHigh" : "kOutputLow";
  if (named == nullptr) return "kInput";
  return named->active_low ? "kInputPullUp" : "kInputPullDown";
}

/// `kind` is its section in the template; `named`: as the board's file knows it, or null.
Data pin_fields(const char* kind, const std::string& pin, const NamedPin* named) {
  Data data;
  set_choice(data, {"is_level", "is_edge", "is_analog"}, kind);
  set_pin(pin, data);
  data.set("is_active_low", is_active_low(named));
  data.set("pin", named != nullptr ? named->name : pin);
  return data;
}

Data level_pin(const std::string& pin, const NamedPin* named, bool is_output) {
  Data data = pin_fields("is_level", pin, named);
  data.set("setting", setting_of(named, is_output));
  return data;
}

Data used_pin(const Device& device, const Use& use) {
  Data data = level_pin(use.pin, use.named, use.spec->function == "output");
  if (use.spec->function == "interrupt") data = pin_fields("is_edge", use.pin, use.named);
  if (use.spec->function == "analog") {
    data = pin_fields("is_analog", use.pin, use.named);
    data.set("converter", use.named->converter);
    data.set("input", std::to_string(use.named->input));
  }
  data.set("user", device.name.text);
  data.set("has_role", true);
  data.set("role", use.spec->role);
  return data;
}

}  // namespace

void set_pin(const std::string& pin, Data& data) {
  const auto [port, number] = pin_name(pin);
  data.set("pin_letter", std::string(1, port));
  data.set("pin_number", std::to_string(number));
}

Data driver_pins(const Plan& plan) {
  Data list(Data::type::list);
  for (const Bus& bus : plan.robot.buses) {
    if (bus.driver_pin.empty()) continue;
    Data entry = level_pin(bus.driver_pin, bus.driver_named, true);
    entry.set("bus", bus.name.text);
    entry.set("port", bus.port);
    list.push_back(entry);
  }
  return list;
}

Data pin_list(const Plan& plan) {
  Data list(Data::type::list);
  for (const Device& device : plan.robot.devices) {
    if (device.segment && bus_type(plan.robot.segments[*device.segment].bus_kind).channels == BusType::Channels::pins) {
      const NamedPin& pin = plan.robot.board->pins.at(device.channel.value_or(0));
      Data entry = level_pin(pin.pin, &pin, pin.functions.front() == "output");
      entry.set("user", device.name.text);
      entry.set("has_role", false);
      list.push_back(entry);
    }
    for (const Use& use : device.uses) {
      if (!use.segment) list.push_back(used_pin(device, use));
    }
  }
  return list;
}

}  // namespace finemote::gen
