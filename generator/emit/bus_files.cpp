#include "generator/emit/bus_files.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/bus/bus_type.hpp"
#include "generator/emit/can_fields.hpp"
#include "generator/emit/config.hpp"
#include "generator/emit/pin_fields.hpp"
#include "generator/emit/scope.hpp"
#include "generator/emit/value.hpp"
#include "generator/model/streamed_frames.hpp"
#include "generator/version.hpp"

namespace finemote::gen {
namespace {

/// Whether the runtime has an object for the bus.
bool is_object(const Bus& bus) { return !bus_type(bus.kind).bus_class.name.empty(); }

/// What PwmBus takes by itself: 50 Hz [ns].
constexpr Duration kServoPeriod = milliseconds(20);

std::vector<const Slot*> slots_of(const Plan& plan, BusId bus) {
  std::vector<const Slot*> slots;
  for (const Slot& slot : plan.schedule.slots) {
    if (plan.robot.segments[slot.segment].bus == bus) slots.push_back(&slot);
  }
  return slots;
}

const SlotClass& slot_class(const Plan& plan, const Slot& slot) {
  return bus_type(plan.robot.segments[slot.segment].bus_kind).slot_class;
}

/// The channel of the mux that a slot's transfers go through: templates/mux_route.mustache.
void set_route(const Plan& plan, const Segment& segment, Data& data) {
  const bool has_mux = segment.kind == Segment::Kind::mux_channel;
  data.set("has_mux", has_mux);
  if (!has_mux) return;
  const Expander& mux = plan.robot.expanders[*segment.expander];
  data.set("mux_address", fmt::format("{:#04x}", mux.address));
  data.set("mux_control", fmt::format("{:#04x}", mux.type->select->control(segment.channel)));
}

Data slot_fields(const Plan& plan, const timing::RobotBounds& bounds, const Scope& scope, const Slot& slot) {
  const Segment& segment = plan.robot.segments[slot.segment];
  const SlotClass& type = slot_class(plan, slot);
  const bool has_mode = type.takes_mode && slot.spi_mode != kUsualSpiMode;
  Data data;
  data.set("class", std::string(type.name));
  data.set("slot", slot.name);
  data.set("bus", scope.of_robot(plan.robot.buses[segment.bus].name.cpp));
  data.set("address", fmt::format("{:#04x}", slot.address));
  data.set("takes_route", type.takes_route);
  set_route(plan, segment, data);
  data.set("takes_identifiers", type.takes_identifiers);
  if (type.takes_identifiers) set_can(plan, bounds, slot, data);
  data.set("priority", std::to_string(slot.priority));
  data.set("has_mode", has_mode);
  data.set("mode", std::to_string(slot.spi_mode));
  return data;
}

Data slot_list(const Plan& plan, const timing::RobotBounds& bounds) {
  const Scope scope = Scope::in_slots(plan);
  Data list(Data::type::list);
  for (const Slot& slot : plan.schedule.slots) list.push_back(slot_fields(plan, bounds, scope, slot));
  return list;
}

/// Per bus: who is on it.
Data route_list(const Plan& plan) {
  Data list(Data::type::list);
  for (const BusId bus : plan.robot.buses.ids()) {
    const std::vector<const Slot*> slots = slots_of(plan, bus);
    if (slots.empty()) continue;
    Data entry, names(Data::type::list);
    for (const Slot* slot : slots) names.push_back(Data("slot", slot->name));
    entry.set("class", std::string(slot_class(plan, *slots.front()).name));
    entry.set("bus", plan.robot.buses[bus].name.cpp);
    entry.set("slots", names);
    list.push_back(entry);
  }
  return list;
}

/// What the device on a uart, or the device that uses it, says about its line; 8N1 when nobody does.
std::string line_format(const Plan& plan, BusId bus) {
  const auto here = [&](std::optional<SegmentId> segment) {
    return segment && plan.robot.segments[*segment].bus == bus;
  };
  for (const Device& device : plan.robot.devices) {
    if (here(device.segment)) return device.type->format;
    for (const Use& use : device.uses) {
      if (here(use.segment)) return use.spec->format;
    }
  }
  return "8N1";
}

/// `8E1_inverted` -> `8E1Inverted`, as the enumerators of the runtime end.
std::string format_name(const std::string& format) {
  const auto mark = format.find('_');
  return mark == std::string::npos ? format : format.substr(0, mark) + "Inverted";
}

/// Serial lines receive into a ring.
bool has_ring(const Bus& bus) { return bus_type(bus.kind).port_class == PortClass::uart; }

Data bus_fields(const Plan& plan, BusId index) {
  const Bus& bus = plan.robot.buses[index];
  const BusType& type = bus_type(bus.kind);
  const Port* port = plan.robot.board->port(bus.port);
  const bool has_period = type.channels == BusType::Channels::outputs && port->period != kServoPeriod;
  const bool has_rate = type.rate.form != nullptr;
  Data data;
  data.set("class", std::string(type.bus_class.name));
  data.set("bus", bus.name.cpp);
  data.set("is_pins", type.channels == BusType::Channels::pins);
  data.set("port", bus.port);
  data.set("has_period", has_period);
  if (has_period) data.set("period", duration_expression(port->period));
  data.set("has_rate", has_rate);
  data.set("rate", std::to_string(bus.rate));
  data.set("rate_unit", std::string(has_rate ? type.rate.form->units[0] : ""));
  data.set("has_slots", !slots_of(plan, index).empty());
  data.set("has_format", type.has_line_format);
  data.set("format", format_name(line_format(plan, index)));
  data.set("has_ring", has_ring(bus));
  data.set("ring", std::to_string(receive_ring(plan.robot, index)));
  data.set("events", std::to_string(line_events(plan.robot, index)));
  data.set("bytes", std::to_string(received_bytes(plan.robot, index)));
  data.set("starts", type.bus_class.starts);
  data.set("is_supervised", type.bus_class.supervised);
  data.set("is_sending", type.bus_class.supervised || has_ring(bus));
  return data;
}

Data bus_list(const Plan& plan) {
  Data list(Data::type::list);
  for (const BusId bus : plan.robot.buses.ids()) {
    if (is_object(plan.robot.buses[bus])) list.push_back(bus_fields(plan, bus));
  }
  return list;
}

std::vector<std::string> expander_includes(const ExpanderType& type) {
  std::vector<std::string> includes{"<" + type.include + ">"};
  if (!type.builtin && !type.params.empty()) includes.emplace_back("<finemote/config.hpp>");
  return includes;
}

Data expander_list(const Plan& plan) {
  Data list(Data::type::list);
  for (const Expander& expander : plan.robot.expanders) {
    const ExpanderType& type = *expander.type;
    if (type.is_mux()) continue;
    Data entry;
    entry.set("expander", expander.name.cpp);
    entry.set("type", type.name);
    entry.set("segment", plan.robot.segments[expander.segment].name.text);
    entry.set("address", fmt::format("{:#04x}", expander.address));
    entry.set("has_config", !expander.params.empty());
    set_config(type.cpp_class, expander.params, type.builtin, entry);
    list.push_back(entry);
  }
  return list;
}

void set_buses(const Plan& plan, const timing::RobotBounds& bounds, Data& data) {
  const auto& buses = plan.robot.buses;
  data.set("has_rings", std::any_of(buses.begin(), buses.end(), [](const Bus& bus) { return has_ring(bus); }));
  data.set("buses", bus_list(plan));
  data.set("expanders", expander_list(plan));
  data.set("has_slots", !plan.schedule.slots.empty());
  data.set("slots", slot_list(plan, bounds));
}

}  // namespace

Data bus_header(const Plan& plan, const timing::RobotBounds& bounds) {
  Data data = common_data(plan);
  data.set("format", std::to_string(kOutputFormat));
  std::vector<std::string> includes{"<finemote/generated_format.hpp>"};
  for (const Bus& bus : plan.robot.buses) {
    if (is_object(bus)) includes.emplace_back(bus_type(bus.kind).bus_class.header);
  }
  for (const Expander& expander : plan.robot.expanders) {
    if (expander.type->is_mux()) continue;
    for (std::string& include : expander_includes(*expander.type)) includes.push_back(std::move(include));
  }
  data.set("includes", include_list(std::move(includes)));
  set_buses(plan, bounds, data);
  return data;
}

Data bus_source(const Plan& plan, const timing::RobotBounds& bounds) {
  Data data = common_data(plan);
  set_buses(plan, bounds, data);
  data.set("routes", route_list(plan));
  data.set("drivers", driver_pins(plan));
  data.set("pins", pin_list(plan));
  return data;
}

}  // namespace finemote::gen
