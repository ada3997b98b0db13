// What `finemote run` is asked for: where a robot runs, how long and under what.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/cli/options.hpp"
#include "generator/pipeline.hpp"
#include "generator/run/parts.hpp"
#include "generator/run/scenario.hpp"

namespace finemote::gen {

/// Settled before anything is generated.
struct RunSetup {
  const Board& board;
  EmulatedParts parts;  ///< what hangs on the emulated one
  Duration duration;
  std::optional<Scenario> scenario;
  std::vector<std::string> silicon;  ///< which freedom of its manual the emulated chip uses

  [[nodiscard]] bool is_emulated() const { return board.is_emulated; }
  [[nodiscard]] const Scenario* asked_scenario() const { return scenario ? &*scenario : nullptr; }
};

/// None after what is wrong was reported: FM0001 of an option, FM3007 and FM3012 of the board that plays the robot,
/// FM6011 of what that cannot do, and what read_scenario reports.
/// @param planned  its library takes the board of --board
std::optional<RunSetup> run_setup(const Options& options, const std::string& data_dir, PlannedRobot& planned,
                                  Sources& sources, Diagnostics& diagnostics);

}  // namespace finemote::gen
