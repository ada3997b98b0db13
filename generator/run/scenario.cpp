#include "generator/run/scenario.hpp"

#include <algorithm>

#include "emulator/scenario/read.hpp"
#include "generator/bus/bus_type.hpp"
#include "generator/json/parse.hpp"
#include "generator/run/bring_up.hpp"
#include "generator/xml/read_source.hpp"

namespace finemote::gen {
namespace {

/// The parts the robot hangs on the board, each at its place.
std::vector<scenario::World::Part> parts_of(const EmulatedParts& hung) {
  Diagnostics none;
  const auto tree = json::parse({"", "", hung.scenario.dump()}, none);
  std::vector<scenario::World::Part> parts;
  for (const json::Value& entry : tree->find("parts")->items) {
    const std::string& type = entry.find("type")->text;
    const scenario::Model* model = scenario::find_model(type);
    parts.push_back({entry.find("name")->text, type});
    if (model != nullptr) parts.back().place = scenario::place_of(entry, *model);
  }
  return parts;
}

/// Ports of buses, and converters behind the pins it measures.
std::vector<std::string> ports_of(const Robot& robot) {
  std::vector<std::string> ports;
  for (const Bus& bus : robot.buses) {
    if (!bus.port.empty()) ports.push_back(bus.port);
  }
  for (const Device& device : robot.devices) {
    for (const Use& use : device.uses) {
      const std::string converter = use.spec->function == "analog" && use.named != nullptr ? use.named->converter : "";
      if (!converter.empty() && std::find(ports.begin(), ports.end(), converter) == ports.end())
        ports.push_back(converter);
    }
  }
  return ports;
}

}  // namespace

scenario::World scenario_world(const Robot& robot, const EmulatedParts& parts, Duration duration) {
  scenario::World world;
  world.parts = parts_of(parts);
  for (const Device& device : robot.devices) {
    const bool has_part = std::any_of(world.parts.begin(), world.parts.end(),
                                      [&](const auto& part) { return part.name == device.name.text; });
    if (!has_part) world.parts.push_back({device.name.text, ""});
  }
  world.ports = ports_of(robot);
  for (const Bus& bus : robot.buses) {
    if (bus_type(bus.kind).has_direction) world.shared.push_back(bus.port);
  }
  for (const Port& port : robot.board->ports) {
    if (!port.selects.empty()) world.selects[port.name] = static_cast<unsigned>(port.selects.size());
  }
  world.duration_ns = (longest_bring_up(robot) + duration).ns();
  return world;
}

std::optional<Scenario> read_scenario(const std::string& path, const Robot& robot, const EmulatedParts& parts,
                                      Duration duration, Sources& sources, Diagnostics& diagnostics) {
  Scenario result;
  result.file = xml::read_source(path, sources, diagnostics);
  if (result.file == nullptr) return std::nullopt;
  const auto tree = scenario::read(*result.file, scenario_world(robot, parts, duration), diagnostics);
  if (!tree) return std::nullopt;
  result.document = nlohmann::ordered_json::parse(result.file->text);
  result.last_event = nanoseconds(scenario::last_event_ns(*tree));
  return result;
}

}  // namespace finemote::gen
