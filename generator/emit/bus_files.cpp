#include "generator/emit/bus_files.hpp"

#include <fmt/format.h>

#include "generator/bus/bus_type.hpp"
#include "generator/emit/config.hpp"
#include "generator/version.hpp"

namespace finemote::gen {
namespace {

/// Whether the runtime has an object for the bus.
bool is_object(const Bus& bus) { return !bus_type(bus.kind).bus_class.name.empty(); }

/// What PwmBus takes by itself: 50 Hz [ns].
constexpr std::int64_t kServoPeriod = 20'000'000;

std::string bus_comment(const Bus& bus) {
  const BusType& type = bus_type(bus.kind);
  if (type.channels == BusType::Channels::pins) return "single pins";
  std::string text = fmt::format("port {}", bus.port);
  if (type.rate.form != nullptr && bus.rate > 0) text += fmt::format(", {} {}", bus.rate, type.rate.form->units[0]);
  return text;
}

std::string expander_comment(const Plan& plan, const Expander& expander) {
  return fmt::format("pca9685 on '{}' at {:#04x}", plan.robot.segments[expander.segment].name.text, expander.address);
}

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

/// `finemote::MuxRoute{0x70, 0x04}`: channel 2 of the mux at 0x70; empty braces: no mux.
std::string mux_route(const Plan& plan, const Segment& segment) {
  if (segment.kind != Segment::Kind::mux_channel) return "finemote::MuxRoute{}";
  const Expander& mux = plan.robot.expanders[*segment.expander];
  return fmt::format("finemote::MuxRoute{{{:#04x}, {:#04x}}}", mux.address, 1u << segment.channel);
}

std::string slot_definition(const Plan& plan, const Slot& slot) {
  const Segment& segment = plan.robot.segments[slot.segment];
  const std::string bus = bus_reference(plan, plan.robot.buses[segment.bus].name.cpp);
  std::string arguments = fmt::format("{}, {:#04x}", bus, slot.address);
  const SlotClass& type = slot_class(plan, slot);
  if (type.takes_route) arguments += ", " + mux_route(plan, segment);
  if (type.takes_own_identifier) {
    const std::uint32_t base = plan.robot.devices[*slot.device].type->receives_base.value_or(0);
    arguments += fmt::format(", /*receives*/ {:#05x}", base + slot.address);
  }
  arguments += fmt::format(", /*priority*/ {}", slot.priority);
  if (type.takes_mode && slot.spi_mode != kUsualSpiMode) arguments += fmt::format(", /*mode*/ {}", slot.spi_mode);
  return fmt::format("FINEMOTE_CONSTINIT finemote::{} {}{{{}}};", type.name, slot.name, arguments);
}

Data slot_list(const Plan& plan) {
  Data list(Data::type::list);
  for (const Slot& slot : plan.schedule.slots) {
    Data entry;
    entry.set("declaration", fmt::format("extern finemote::{} {};", slot_class(plan, slot).name, slot.name));
    entry.set("definition", slot_definition(plan, slot));
    list.push_back(entry);
  }
  return list;
}

/// Beside the buses: a name that no bus can have.
std::string routes_name(const Bus& bus) { return "finemote_" + bus.name.cpp + "_slots"; }

std::vector<std::string> route_lines(const Plan& plan) {
  std::vector<std::string> lines;
  for (const BusId i : plan.robot.buses.ids()) {
    const std::vector<const Slot*> slots = slots_of(plan, i);
    if (slots.empty()) continue;
    lines.push_back(fmt::format("constexpr finemote::{}* {}[] = {{", slot_class(plan, *slots.front()).name,
                                routes_name(plan.robot.buses[i])));
    for (const Slot* slot : slots) lines.push_back(fmt::format("    &slots::{},", slot->name));
    lines.push_back("};");
  }
  return lines;
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

/// `8E1_inverted` -> `finemote::UartFormat::k8E1Inverted`.
std::string format_enumerator(const std::string& format) {
  const auto mark = format.find('_');
  if (mark == std::string::npos) return "finemote::UartFormat::k" + format;
  return "finemote::UartFormat::k" + format.substr(0, mark) + "Inverted";
}

std::string bus_definition(const Plan& plan, BusId index) {
  const Bus& bus = plan.robot.buses[index];
  const BusType& type = bus_type(bus.kind);
  std::string arguments = "finemote::ports::" + (type.channels == BusType::Channels::pins ? "gpio" : bus.port);
  if (const Port* port = plan.robot.board->port(bus.port);
      type.channels == BusType::Channels::outputs && port->period_ns != kServoPeriod) {
    arguments += fmt::format(", {} /* ns */", port->period_ns);
  }
  if (type.rate.form != nullptr) arguments += fmt::format(", {} /* {} */", bus.rate, type.rate.form->units[0]);
  if (!slots_of(plan, index).empty()) arguments += ", " + routes_name(bus);
  if (type.has_line_format) arguments += ", " + format_enumerator(line_format(plan, index));
  return fmt::format("FINEMOTE_CONSTINIT finemote::{} {}{{{}}};", type.bus_class.name, bus.name.cpp, arguments);
}

std::string expander_definition(const Plan& plan, const Expander& expander) {
  std::string arguments = bus_reference(plan, "slots::" + expander.name.cpp);
  if (!expander.params.empty())
    arguments += ",\n    " + config_expression("finemote::Pca9685", expander.params, /*is_shipped*/ true);
  return fmt::format("FINEMOTE_CONSTINIT finemote::Pca9685 {}{{{}}};", expander.name.cpp, arguments);
}

bool is_object(const Expander& expander) { return expander.model == Expander::Model::pca9685; }

Data bus_list(const Plan& plan) {
  Data list(Data::type::list);
  const auto add = [&](std::string_view type, const std::string& name, const std::string& comment,
                       const std::string& definition) {
    Data entry;
    entry.set("declaration", fmt::format("extern finemote::{} {};  // {}", type, name, comment));
    entry.set("definition", definition);
    list.push_back(entry);
  };
  for (const BusId i : plan.robot.buses.ids()) {
    const Bus& bus = plan.robot.buses[i];
    if (is_object(bus)) add(bus_type(bus.kind).bus_class.name, bus.name.cpp, bus_comment(bus), bus_definition(plan, i));
  }
  for (const Expander& expander : plan.robot.expanders) {
    if (is_object(expander)) {
      add("Pca9685", expander.name.cpp, expander_comment(plan, expander), expander_definition(plan, expander));
    }
  }
  return list;
}

/// `finemote::ports::gpio.configure(finemote::pin_number('A', 0), finemote::PinSetting::kInputPullUp);`: idle is
/// inactive.
std::string configure_line(const std::string& pin, const NamedPin* named, bool is_output) {
  const bool idle_high = named != nullptr && named->active_low;
  const char* mode = is_output          ? (idle_high ? "kOutputHigh" : "kOutputLow")
                     : named == nullptr ? "kInput"
                     : idle_high        ? "kInputPullUp"
                                        : "kInputPullDown";
  return fmt::format("finemote::ports::gpio.configure({}, finemote::PinSetting::{});", pin_number(pin), mode);
}

std::string start_line(const Use& use) {
  const bool active_low = use.named != nullptr && use.named->active_low;
  if (use.spec->function == "interrupt") {
    return fmt::format("finemote::ports::exti{}.start(/*falling*/ {});", use.pin.substr(2), active_low);
  }
  if (use.spec->function == "analog") {
    return fmt::format("finemote::ports::{}.start({}, {});", use.named->converter, use.named->input,
                       pin_number(use.pin));
  }
  return configure_line(use.pin, use.named, use.spec->function == "output");
}

/// Brings up the pins that devices use or sit on.
std::vector<std::string> pin_lines(const Plan& plan) {
  std::vector<std::string> lines;
  for (const Bus& bus : plan.robot.buses) {
    if (bus.driver_pin.empty()) continue;
    const bool active_low = bus.driver_named != nullptr && bus.driver_named->active_low;
    lines.push_back(configure_line(bus.driver_pin, bus.driver_named, true) + "  // direction of " + bus.name.text);
    lines.push_back(fmt::format("finemote::ports::{}.drive_with({}, /*active low*/ {});", bus.port,
                                pin_number(bus.driver_pin), active_low));
  }
  for (const Device& device : plan.robot.devices) {
    const bool on_pin =
        device.segment && bus_type(plan.robot.segments[*device.segment].bus_kind).channels == BusType::Channels::pins;
    if (on_pin) {
      const NamedPin& pin = plan.robot.board->pins.at(device.channel.value_or(0));
      const std::string what = fmt::format("  // {}: {}", device.name.text, pin.name);
      lines.push_back(configure_line(pin.pin, &pin, pin.functions.front() == "output") + what);
    }
    for (const Use& use : device.uses) {
      if (use.segment) continue;
      const std::string& name = use.named != nullptr ? use.named->name : use.pin;
      lines.push_back(start_line(use) + fmt::format("  // {} ({}): {}", device.name.text, use.spec->role, name));
    }
  }
  return lines;
}

std::vector<std::string> call_lines(const Plan& plan, bool BusClass::*wanted, const char* call) {
  std::vector<std::string> lines;
  for (const Bus& bus : plan.robot.buses) {
    if (bus_type(bus.kind).bus_class.*wanted) lines.push_back(fmt::format("{}.{}();", bus.name.cpp, call));
  }
  return lines;
}

}  // namespace

Data bus_header(const Plan& plan) {
  Data data = common_data(plan);
  data.set("format", std::to_string(kOutputFormat));
  std::vector<std::string> includes{"<finemote/generated_format.hpp>"};
  for (const Bus& bus : plan.robot.buses) {
    if (is_object(bus)) includes.emplace_back(bus_type(bus.kind).bus_class.header);
  }
  for (const Expander& expander : plan.robot.expanders) {
    if (is_object(expander)) includes.emplace_back("<finemote/pca9685.hpp>");
  }
  data.set("includes", include_list(std::move(includes)));
  data.set("buses", bus_list(plan));
  data.set("has_slots", !plan.schedule.slots.empty());
  data.set("slots", slot_list(plan));
  return data;
}

Data bus_source(const Plan& plan) {
  Data data = common_data(plan);
  data.set("buses", bus_list(plan));
  data.set("has_slots", !plan.schedule.slots.empty());
  data.set("slots", slot_list(plan));
  const std::vector<std::string> routes = route_lines(plan);
  data.set("has_routes", !routes.empty());
  data.set("routes", text_list(routes));
  std::vector<std::string> starts = call_lines(plan, &BusClass::starts, "start");
  for (std::string& line : pin_lines(plan)) starts.push_back(std::move(line));
  data.set("start_lines", text_list(starts));
  data.set("supervise_lines", text_list(call_lines(plan, &BusClass::supervised, "supervise")));
  return data;
}

}  // namespace finemote::gen
