#include "generator/cli/run_setup.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "emulator/silicon/choice.hpp"
#include "generator/cli/named_board.hpp"
#include "generator/cli/subject.hpp"
#include "generator/diagnostic/code_scenario.hpp"
#include "generator/model/attributes.hpp"
#include "generator/run/duration.hpp"

namespace finemote::gen {
namespace {

std::optional<Duration> duration_of(const Options& options, const Schedule& schedule, Diagnostics& diagnostics) {
  if (options.duration.empty()) return default_duration(schedule);
  return duration_option(options, "100ms", "instruction", diagnostics);
}

/// The first bus whose port the board lacks; null: none, or the board takes every port.
const Bus* bus_without_port(const Robot& robot, const Board& board) {
  if (board.stands_in) return nullptr;
  const auto lacks = [&](const Bus& bus) { return !bus.port.empty() && board.port(bus.port) == nullptr; };
  const auto found = std::find_if(robot.buses.begin(), robot.buses.end(), lacks);
  return found == robot.buses.end() ? nullptr : &*found;
}

/// The board that plays the robot: its own, or that of --board. Null after what is wrong with it was reported: FM3007
/// where there is none of that name, FM3012 where it lacks a port of the robot.
const Board* playing_board(const std::string& name, PlannedRobot& planned, Sources& sources, Diagnostics& diagnostics) {
  if (name.empty()) return planned.robot.board;
  const Board* board = named_board(name, planned.library, sources, diagnostics);
  const Bus* bus = board != nullptr ? bus_without_port(planned.robot, *board) : nullptr;
  if (bus == nullptr) return board;
  diagnostics
      .error(code::unknown_port, {}, fmt::format("board '{}' has no port '{}', which the robot uses", name, bus->port))
      .hint(fmt::format("leave out --board: the robot's own is '{}'", planned.robot.board->name));
  return nullptr;
}

/// The scenario that was asked for; none where it is wrong.
std::optional<Scenario> read_asked_scenario(const std::string& path, PlannedRobot& planned, const RunSetup& setup,
                                            Sources& sources, Diagnostics& diagnostics) {
  if (setup.is_emulated()) return read_scenario(path, planned.robot, setup.parts, setup.duration, sources, diagnostics);
  const Board& own = *planned.robot.board;
  diagnostics
      .error(code::scenario_unjudged, {},
             fmt::format("nothing can play a scenario on the board '{}'", setup.board.name))
      .note("it has no parts on its buses")
      .hint(fmt::format("--board {}", own.is_emulated ? own.name : suggested_board(planned.library, sources)));
  return std::nullopt;
}

/// Reports what only the emulated board can do.
bool can_watch(const Options& options, const RunSetup& setup, Diagnostics& diagnostics) {
  const char* asked = !options.audit.empty()     ? "--audit"
                      : options.phases != 0      ? "--phases"
                      : !options.silicon.empty() ? "--silicon"
                      : options.slowest          ? "--slowest"
                                                 : nullptr;
  if (setup.is_emulated() || asked == nullptr) return true;
  diagnostics
      .error(
          code::scenario_unjudged, {},
          fmt::format("'{}' needs the emulated board: '{}' has no parts and keeps no record", asked, setup.board.name))
      .hint("leave out --board");
  return false;
}

}  // namespace

std::optional<RunSetup> run_setup(const Options& options, const std::string& data_dir, PlannedRobot& planned,
                                  Sources& sources, Diagnostics& diagnostics) {
  const Board* board = playing_board(options.board, planned, sources, diagnostics);
  if (board == nullptr) return std::nullopt;
  const auto duration = duration_of(options, planned.schedule, diagnostics);
  if (!duration) return std::nullopt;
  const std::string strictness = options.slowest && options.silicon.empty() ? "strict" : options.silicon;
  auto silicon = emulator::parse_silicon(strictness, diagnostics);
  if (!silicon) return std::nullopt;
  RunSetup setup{
      *board, emulated_parts(planned.robot, command_frames(planned, data_dir)), *duration, {}, std::move(*silicon)};
  if (!can_watch(options, setup, diagnostics)) return std::nullopt;
  if (options.scenario.empty()) return setup;
  setup.scenario = read_asked_scenario(options.scenario, planned, setup, sources, diagnostics);
  if (!setup.scenario) return std::nullopt;
  return setup;
}

}  // namespace finemote::gen
