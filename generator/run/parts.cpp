#include "generator/run/parts.hpp"

#include <algorithm>
#include <array>

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

/// Device types that the emulator models under the same name.
constexpr std::array kModelled{"h30_imu", "ms5837"};

bool is_modelled(const Device& device) {
  return std::find(kModelled.begin(), kModelled.end(), device.type->name) != kModelled.end();
}

/// Where a part sits: behind a mux channel, or at a port.
void add_place(const Robot& robot, std::size_t index, Json& part) {
  const Segment& segment = robot.segments[index];
  if (segment.kind == Segment::Kind::mux_channel) {
    part["mux"] = robot.expanders[*segment.expander].name.text;
    part["channel"] = segment.channel;
  } else {
    part["port"] = robot.buses[segment.bus].port;
  }
}

void add_line_format(const Bus& bus, const std::string& format, Json& part) {
  part["baud"] = bus.rate;
  part["even_parity"] = format.find('E') != std::string::npos;
  part["stop_bits"] = format.size() > 2 && format[2] == '2' ? 2 : 1;
}

Json expander_part(const Robot& robot, const Expander& expander) {
  Json part{{"type", expander.model == Expander::Model::pca9685 ? "pca9685" : "tca9548a"}, {"name", expander.name.text}};
  add_place(robot, expander.segment, part);
  part["address"] = expander.address;
  return part;
}

Json device_part(const Robot& robot, const Device& device) {
  Json part{{"type", device.type->name}, {"name", device.name.text}};
  add_place(robot, *device.segment, part);
  const Segment& segment = robot.segments[*device.segment];
  if (segment.bus_kind == BusKind::uart) {
    add_line_format(robot.buses[segment.bus], device.type->format, part);
    part["period_ns"] = device.period_ns;
  }
  for (const Param& param : device.params) {
    if (param.spec->name == "variant") part["variant"] = std::get<std::string>(param.value);
  }
  return part;
}

/// A serial line that a device uses for people or a computer: a terminal at its other end.
Json terminal_part(const Robot& robot, const Device& device, const Use& use) {
  Json part{{"type", "host_terminal"}, {"name", device.name.text + "." + use.spec->role}};
  add_place(robot, *use.segment, part);
  add_line_format(robot.buses[robot.segments[*use.segment].bus], use.spec->format, part);
  return part;
}

}  // namespace

Json emulated_parts(const Robot& robot) {
  Json parts = Json::array();
  for (const Expander& expander : robot.expanders) parts.push_back(expander_part(robot, expander));
  for (const Device& device : robot.devices) {
    if (device.segment && is_modelled(device)) parts.push_back(device_part(robot, device));
    for (const Use& use : device.uses) {
      const bool serial = use.segment && robot.segments[*use.segment].bus_kind == BusKind::uart;
      if (serial) parts.push_back(terminal_part(robot, device, use));
    }
  }
  return Json{{"schema", "finemote.scenario/1"}, {"parts", parts}, {"events", Json::array()}};
}

}  // namespace finemote::gen
