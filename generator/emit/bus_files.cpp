#include "generator/emit/bus_files.hpp"

#include <fmt/format.h>

#include "generator/emit/config.hpp"
#include "generator/emit/pin_fields.hpp"
#include "generator/emit/scope.hpp"
#include "generator/emit/value.hpp"
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

/// The channel of the mux that a slot's transfers go through: templates/mux_route.mustache.
void set_route(const Plan& plan, const Segment& segment, Data& data) {
  const bool has_mux = segment.kind == Segment::Kind::mux_channel;
  data.set("has_mux", has_mux);
  if (!has_mux) return;
  const Expander& mux = plan.robot.expanders[*segment.expander];
  data.set("mux_address", fmt::format("{:#04x}", mux.address));
  data.set("mux_control", fmt::format("{:#04x}", 1u << segment.channel));
}

Data slot_fields(const Plan& plan, const Slot& slot) {
  const Segment& segment = plan.robot.segments[slot.segment];
  const bool is_can = segment.bus_kind == BusKind::can;
  Data data;
  data.set("class", slot_names(plan, slot).slot);
  data.set("slot", slot.name);
  data.set("bus", Scope::in_slots(plan).of_robot(plan.robot.buses[segment.bus].name.cpp));
  data.set("address", fmt::format("{:#04x}", slot.address));
  data.set("takes_route", segment.bus_kind == BusKind::i2c);
  set_route(plan, segment, data);
  data.set("takes_identifier", is_can);
  if (is_can) {
    const std::uint32_t base = plan.robot.devices[*slot.device].type->receives_base.value_or(0);
    data.set("receives", fmt::format("{:#05x}", base + slot.address));
  }
  data.set("priority", std::to_string(slot.priority));
  data.set("has_mode", slot.spi_mode != kUsualSpiMode);
  data.set("mode", std::to_string(slot.spi_mode));
  return data;
}

Data slot_list(const Plan& plan) {
  Data list(Data::type::list);
  for (const Slot& slot : plan.schedule.slots) list.push_back(slot_fields(plan, slot));
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
    entry.set("class", slot_names(plan, *slots.front()).slot);
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

Data bus_fields(const Plan& plan, BusId index) {
  const Bus& bus = plan.robot.buses[index];
  const KindNames& names = *kind_names(bus.kind);
  const Port* port = plan.robot.board->port(bus.port);
  const bool has_period = bus.kind == BusKind::pwm && port->period_ns != kServoPeriod;
  const bool has_rate = names.rate_unit != nullptr;
  Data data;
  data.set("class", names.bus);
  data.set("bus", bus.name.cpp);
  data.set("is_pins", bus.kind == BusKind::gpio);
  data.set("port", bus.port);
  data.set("has_period", has_period);
  if (has_period) data.set("period", duration_expression(port->period_ns));
  data.set("has_rate", has_rate);
  data.set("rate", std::to_string(bus.rate));
  data.set("rate_unit", has_rate ? names.rate_unit : "");
  data.set("has_slots", !slots_of(plan, index).empty());
  data.set("has_format", bus.kind == BusKind::uart);
  data.set("format", format_name(line_format(plan, index)));
  data.set("starts", names.starts);
  data.set("is_supervised", names.supervised);
  return data;
}

Data bus_list(const Plan& plan) {
  Data list(Data::type::list);
  for (const BusId bus : plan.robot.buses.ids()) {
    if (kind_names(plan.robot.buses[bus].kind) != nullptr) list.push_back(bus_fields(plan, bus));
  }
  return list;
}

bool is_object(const Expander& expander) { return expander.model == Expander::Model::pca9685; }

Data expander_list(const Plan& plan) {
  Data list(Data::type::list);
  for (const Expander& expander : plan.robot.expanders) {
    if (!is_object(expander)) continue;
    Data entry;
    entry.set("expander", expander.name.cpp);
    entry.set("type", "pca9685");
    entry.set("segment", plan.robot.segments[expander.segment].name.text);
    entry.set("address", fmt::format("{:#04x}", expander.address));
    entry.set("has_config", !expander.params.empty());
    set_config("finemote::Pca9685", expander.params, /*is_shipped*/ true, entry);
    list.push_back(entry);
  }
  return list;
}

void set_buses(const Plan& plan, Data& data) {
  data.set("buses", bus_list(plan));
  data.set("expanders", expander_list(plan));
  data.set("has_slots", !plan.schedule.slots.empty());
  data.set("slots", slot_list(plan));
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
    if (is_object(expander)) includes.emplace_back("<finemote/pca9685.hpp>");
  }
  data.set("includes", include_list(std::move(includes)));
  set_buses(plan, data);
  return data;
}

Data bus_source(const Plan& plan) {
  Data data = common_data(plan);
  set_buses(plan, data);
  data.set("routes", route_list(plan));
  data.set("drivers", driver_pins(plan));
  data.set("pins", pin_list(plan));
  return data;
}

}  // namespace finemote::gen
