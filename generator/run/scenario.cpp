#include "generator/run/scenario.hpp"

#include <algorithm>

#include "emulator/scenario/read.hpp"
#include "generator/run/parts.hpp"
#include "generator/xml/read_source.hpp"

namespace finemote::gen {
namespace {

/// The parts the robot hangs on the board, its devices without one, and the ports it uses.
scenario::World world_of(const Robot& robot, std::int64_t duration_ns) {
  scenario::World world;
  const EmulatedParts emulated = emulated_parts(robot);
  for (const auto& part : emulated.scenario.at("parts")) world.parts.push_back({part.at("name"), part.at("type")});
  for (const Device& device : robot.devices) {
    const bool has_part = std::any_of(world.parts.begin(), world.parts.end(),
                                      [&](const auto& part) { return part.name == device.name.text; });
    if (!has_part) world.parts.push_back({device.name.text, ""});
  }
  world.ports.emplace();
  for (const Bus& bus : robot.buses) {
    if (!bus.port.empty()) world.ports->push_back(bus.port);
  }
  world.duration_ns = duration_ns;
  return world;
}

}  // namespace

std::optional<Scenario> read_scenario(const std::string& path, const Robot& robot, std::int64_t duration_ns,
                                      Sources& sources, Diagnostics& diagnostics) {
  Scenario result;
  result.file = xml::read_source(path, sources, diagnostics);
  if (result.file == nullptr) return std::nullopt;
  const auto tree = scenario::read(*result.file, world_of(robot, duration_ns), diagnostics);
  if (!tree) return std::nullopt;
  result.document = nlohmann::ordered_json::parse(result.file->text);
  result.last_event_ns = scenario::last_event_ns(*tree);
  return result;
}

}  // namespace finemote::gen
