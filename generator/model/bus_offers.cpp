#include "generator/model/bus_offers.hpp"

#include <algorithm>

#include "generator/bus/bus_type.hpp"
#include "generator/bus/line_format.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/model/attributes.hpp"

namespace finemote::gen {
namespace {

/// A bus for devices with an inverted line needs a port with an inverter, any other one without.
bool suits_line(const Port& port, const std::vector<const DeviceType*>& types) {
  return std::all_of(types.begin(), types.end(), [&](const DeviceType* type) {
    return line_format(type->format).is_inverted == port.has_inverter;
  });
}

}  // namespace

std::vector<std::string> ports_for(const Board& board, std::optional<BusKind> kind) {
  std::vector<std::string> names;
  for (const Port& port : board.ports) {
    if (!kind || port.serves(*kind)) names.push_back(port.name);
  }
  return names;
}

std::vector<std::string> unclaimed(const Reading& reading, const std::vector<std::string>& ports) {
  std::vector<std::string> names;
  for (const std::string& port : ports) {
    const auto& tags = reading.tags.buses;
    const auto claims = [&](const xml::Node* tag) { return value_of(*tag, "port") == port; };
    if (std::none_of(tags.begin(), tags.end(), claims)) names.push_back(port);
  }
  return names.empty() ? ports : names;
}

std::string example_port(const Reading& reading, std::optional<BusKind> kind) {
  const Board* board = reading.robot.board;
  const auto names = board != nullptr ? unclaimed(reading, ports_for(*board, kind)) : std::vector<std::string>{};
  return names.empty() ? std::string() : names.front();
}

std::vector<const DeviceType*> types_on(Reading& reading, std::string_view bus) {
  const std::vector<std::string> known = device_type_names(reading.library);
  std::vector<const DeviceType*> types;
  for (const DeviceTag& tag : reading.tags.devices) {
    const std::string name(value_of(*tag.node, "type"));
    if (value_of(*tag.node, "bus") != bus || std::find(known.begin(), known.end(), name) == known.end()) continue;
    const DeviceType* type = find_device_type(reading.library, name, reading.sources, reading.diagnostics);
    if (type != nullptr) types.push_back(type);
  }
  return types;
}

std::int64_t clock_of_parts(Reading& reading, std::string_view bus) {
  std::int64_t clock = INT64_MAX;
  for (const DeviceType* type : types_on(reading, bus)) clock = std::min(clock, type->max_clock_hz.value_or(clock));
  return clock;
}

std::vector<std::string> suitable_ports(Reading& reading, const xml::Node& tag, BusKind kind) {
  const std::vector<const DeviceType*> types = types_on(reading, value_of(tag, "name"));
  const auto& tags = reading.tags.buses;
  std::vector<std::string> names;
  for (const Port& port : reading.robot.board->ports) {
    const bool is_named = std::any_of(tags.begin(), tags.end(),
                                      [&](const xml::Node* other) { return value_of(*other, "port") == port.name; });
    if (port.serves(kind) && !is_named && (!bus_type(kind).has_line_format || suits_line(port, types)))
      names.push_back(port.name);
  }
  return names;
}

}  // namespace finemote::gen
