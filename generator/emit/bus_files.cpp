#include "generator/emit/bus_files.hpp"

#include <fmt/format.h>

#include "generator/emit/config.hpp"
#include "generator/version.hpp"

namespace finemote::gen {
namespace {

/// What each kind of bus is called in the runtime.
struct KindNames {
  const char* bus;
  const char* slot;  ///< null: devices use the bus itself
  const char* include;
  const char* rate_unit;  ///< null: has no rate
  bool starts;
  bool supervised;
};

const KindNames* kind_names(BusKind kind) {
  static constexpr KindNames kUart{"Uart", nullptr, "<finemote/uart.hpp>", "baud", true, false};
  static constexpr KindNames kRs485{"Rs485", "Rs485Slot", "<finemote/rs485.hpp>", "baud", true, true};
  static constexpr KindNames kI2c{"I2cBus", "I2cSlot", "<finemote/i2c.hpp>", "Hz", true, true};
  static constexpr KindNames kSpi{"SpiBus", "SpiSlot", "<finemote/spi.hpp>", "Hz", true, true};
  static constexpr KindNames kCan{"CanBus", "CanSlot", "<finemote/can.hpp>", "bit/s", true, true};
  static constexpr KindNames kPwm{"PwmBus", nullptr, "<finemote/pwm.hpp>", nullptr, true, false};
  static constexpr KindNames kGpio{"GpioBus", nullptr, "<finemote/gpio.hpp>", nullptr, true, false};
  switch (kind) {
    case BusKind::uart:
      return &kUart;
    case BusKind::rs485:
      return &kRs485;
    case BusKind::i2c:
      return &kI2c;
    case BusKind::spi:
      return &kSpi;
    case BusKind::can:
      return &kCan;
    case BusKind::pwm:
      return &kPwm;
    case BusKind::gpio:
      return &kGpio;
    case BusKind::virtual_bus:
      break;
  }
  return nullptr;
}

/// What PwmBus takes by itself: 50 Hz [ns].
constexpr std::int64_t kServoPeriod = 20'000'000;

std::string bus_comment(const Bus& bus) {
  const KindNames& names = *kind_names(bus.kind);
  if (bus.kind == BusKind::gpio) return "single pins";
  std::string text = fmt::format("port {}", bus.port);
  if (names.rate_unit != nullptr && bus.rate > 0) text += fmt::format(", {} {}", bus.rate, names.rate_unit);
  return text;
}

std::string expander_comment(const Plan& plan, const Expander& expander) {
  return fmt::format("{} on '{}' at {:#04x}", expander.type->name, plan.robot.segments[expander.segment].name.text,
                     expander.address);
}

std::vector<const Slot*> slots_of(const Plan& plan, BusId bus) {
  std::vector<const Slot*> slots;
  for (const Slot& slot : plan.schedule.slots) {
    if (plan.robot.segments[slot.segment].bus == bus) slots.push_back(&slot);
  }
  return slots;
}

const KindNames& slot_names(const Plan& plan, const Slot& slot) {
  return *kind_names(plan.robot.segments[slot.segment].bus_kind);
}

/// `finemote::MuxRoute{0x70, 0x04}`: channel 2 of the mux at 0x70; empty braces: no mux.
std::string mux_route(const Plan& plan, const Segment& segment) {
  if (segment.kind != Segment::Kind::mux_channel) return "finemote::MuxRoute{}";
  const Expander& mux = plan.robot.expanders[*segment.expander];
  return fmt::format("finemote::MuxRoute{{{:#04x}, {:#04x}}}", mux.address, mux.type->select->control(segment.channel));
}

/// What the slot's device sends on CAN; a further slot of a device receives nothing.
std::vector<IdentifierRange> received_by(const Plan& plan, const Slot& slot) {
  if (!slot.device) return {};
  const Device& device = plan.robot.devices[*slot.device];
  return device.segment == slot.segment ? device.type->received(slot.address) : std::vector<IdentifierRange>();
}

/// `0x201`, or `finemote::CanIds{0x020, 32}`.
std::string identifiers(const IdentifierRange& range) {
  return range.count == 1 ? fmt::format("{:#05x}", range.first)
                          : fmt::format("finemote::CanIds{{{:#05x}, {}}}", range.first, range.count);
}

/// Where a slot keeps frames with further identifiers, beside the slot: a name that no slot can have.
std::string inboxes_name(const Slot& slot) { return "finemote_" + slot.name + "_inboxes"; }

/// `finemote::CanInbox finemote_drive_inboxes[2]{...};`, one for each identifier after the first; empty: none.
std::string inboxes_definition(const Plan& plan, const Slot& slot) {
  const std::vector<IdentifierRange> ranges = received_by(plan, slot);
  if (ranges.size() < 2) return {};
  std::string list;
  for (std::size_t i = 1; i < ranges.size(); ++i) {
    const std::string next = i + 1 < ranges.size() ? fmt::format(", &{}[{}]", inboxes_name(slot), i) : "";
    list += fmt::format("{}finemote::CanInbox{{{}{}}}", i > 1 ? ", " : "", identifiers(ranges[i]), next);
  }
  return fmt::format("FINEMOTE_CONSTINIT finemote::CanInbox {}[{}]{{{}}};", inboxes_name(slot), ranges.size() - 1,
                     list);
}

/// The part of a shared frame that is the device's, and its further inboxes, as far as it has them.
std::string can_extras(const Plan& plan, const Slot& slot, std::size_t ranges) {
  if (!slot.device) return {};
  const Device& device = plan.robot.devices[*slot.device];
  const auto frame = device.segment == slot.segment ? device.type->shared_frame(slot.address) : std::nullopt;
  std::string text;
  if (frame) {
    text += fmt::format(", /*shares*/ finemote::CanShare{{{:#05x}, {}, {}}}", frame->identifier,
                        frame->offset(slot.address), frame->width);
  } else if (ranges > 1) {
    text += ", finemote::CanShare{}";
  }
  return ranges > 1 ? text + ", " + inboxes_name(slot) : text;
}

std::string slot_definition(const Plan& plan, const Slot& slot) {
  const Segment& segment = plan.robot.segments[slot.segment];
  const std::string bus = bus_reference(plan, plan.robot.buses[segment.bus].name.cpp);
  std::string arguments = fmt::format("{}, {:#04x}", bus, slot.address);
  if (segment.bus_kind == BusKind::i2c) arguments += ", " + mux_route(plan, segment);
  const std::vector<IdentifierRange> ranges = received_by(plan, slot);
  if (segment.bus_kind == BusKind::can) {
    arguments += ", /*receives*/ " + (ranges.empty() ? "finemote::CanIds{}" : identifiers(ranges.front()));
  }
  arguments += fmt::format(", /*priority*/ {}", slot.priority);
  if (segment.bus_kind == BusKind::can) arguments += can_extras(plan, slot, ranges.size());
  if (slot.spi_mode != kUsualSpiMode) arguments += fmt::format(", /*mode*/ {}", slot.spi_mode);
  return fmt::format("FINEMOTE_CONSTINIT finemote::{} {}{{{}}};", slot_names(plan, slot).slot, slot.name, arguments);
}

Data slot_list(const Plan& plan) {
  Data list(Data::type::list);
  for (const Slot& slot : plan.schedule.slots) {
    if (const std::string inboxes = inboxes_definition(plan, slot); !inboxes.empty()) {
      Data entry;
      entry.set("declaration", fmt::format("extern finemote::CanInbox {}[];", inboxes_name(slot)));
      entry.set("definition", inboxes);
      list.push_back(entry);
    }
    Data entry;
    entry.set("declaration", fmt::format("extern finemote::{} {};", slot_names(plan, slot).slot, slot.name));
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
    lines.push_back(fmt::format("constexpr finemote::{}* {}[] = {{", slot_names(plan, *slots.front()).slot,
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
  const KindNames& names = *kind_names(bus.kind);
  std::string arguments = "finemote::ports::" + (bus.kind == BusKind::gpio ? "gpio" : bus.port);
  if (const Port* port = plan.robot.board->port(bus.port);
      bus.kind == BusKind::pwm && port->period_ns != kServoPeriod) {
    arguments += fmt::format(", {} /* ns */", port->period_ns);
  }
  if (names.rate_unit != nullptr) arguments += fmt::format(", {} /* {} */", bus.rate, names.rate_unit);
  if (!slots_of(plan, index).empty()) arguments += ", " + routes_name(bus);
  if (bus.kind == BusKind::uart) arguments += ", " + format_enumerator(line_format(plan, index));
  return fmt::format("FINEMOTE_CONSTINIT finemote::{} {}{{{}}};", names.bus, bus.name.cpp, arguments);
}

std::string expander_definition(const Plan& plan, const Expander& expander) {
  const ExpanderType& type = *expander.type;
  std::string arguments = bus_reference(plan, "slots::" + expander.name.cpp);
  if (!expander.params.empty())
    arguments += ",\n    " + config_expression(type.cpp_class, expander.params, type.builtin);
  return fmt::format("FINEMOTE_CONSTINIT {} {}{{{}}};", type.cpp_class, expander.name.cpp, arguments);
}

std::vector<std::string> expander_includes(const ExpanderType& type) {
  std::vector<std::string> includes{"<" + type.include + ">"};
  if (!type.builtin && !type.params.empty()) includes.emplace_back("<finemote/config.hpp>");
  return includes;
}

Data bus_list(const Plan& plan) {
  Data list(Data::type::list);
  const auto add = [&](const std::string& type, const std::string& name, const std::string& comment,
                       const std::string& definition) {
    Data entry;
    entry.set("declaration", fmt::format("extern {} {};  // {}", type, name, comment));
    entry.set("definition", definition);
    list.push_back(entry);
  };
  for (const BusId i : plan.robot.buses.ids()) {
    const Bus& bus = plan.robot.buses[i];
    if (const KindNames* names = kind_names(bus.kind))
      add(fmt::format("finemote::{}", names->bus), bus.name.cpp, bus_comment(bus), bus_definition(plan, i));
  }
  for (const Expander& expander : plan.robot.expanders) {
    if (!expander.type->is_mux()) {
      add(expander.type->cpp_class, expander.name.cpp, expander_comment(plan, expander),
          expander_definition(plan, expander));
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
    const bool on_pin = device.segment && plan.robot.segments[*device.segment].bus_kind == BusKind::gpio;
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

std::vector<std::string> call_lines(const Plan& plan, bool KindNames::*wanted, const char* call) {
  std::vector<std::string> lines;
  for (const Bus& bus : plan.robot.buses) {
    const KindNames* names = kind_names(bus.kind);
    if (names != nullptr && names->*wanted) lines.push_back(fmt::format("{}.{}();", bus.name.cpp, call));
  }
  return lines;
}

}  // namespace

Data bus_header(const Plan& plan) {
  Data data = common_data(plan);
  data.set("format", std::to_string(kOutputFormat));
  std::vector<std::string> includes{"<finemote/generated_format.hpp>"};
  for (const Bus& bus : plan.robot.buses) {
    if (const KindNames* names = kind_names(bus.kind)) includes.emplace_back(names->include);
  }
  for (const Expander& expander : plan.robot.expanders) {
    if (expander.type->is_mux()) continue;
    for (std::string& include : expander_includes(*expander.type)) includes.push_back(std::move(include));
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
  std::vector<std::string> starts = call_lines(plan, &KindNames::starts, "start");
  for (std::string& line : pin_lines(plan)) starts.push_back(std::move(line));
  data.set("start_lines", text_list(starts));
  data.set("supervise_lines", text_list(call_lines(plan, &KindNames::supervised, "supervise")));
  return data;
}

}  // namespace finemote::gen
