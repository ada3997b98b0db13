// A scenario file to a document that the emulated board can play to its end.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "emulator/scenario/check.hpp"
#include "generator/diagnostic/diagnostics.hpp"
#include "generator/model/robot.hpp"
#include "generator/run/parts.hpp"

namespace finemote::gen {

struct Scenario {
  const SourceFile* file = nullptr;
  nlohmann::ordered_json document;
  Duration last_event;  ///< since the first release; 0 without events
};

/// What is there before a scenario is read: the parts the robot hangs on the board, its devices without one, and the
/// ports it uses.
scenario::World scenario_world(const Robot& robot, const EmulatedParts& parts, Duration duration);

/// Reads the file and checks it against the robot's parts and buses. `duration`: of the run. Nothing is generated or
/// compiled for it. Reports what xml::read_source and scenario::read report; nothing after an error.
std::optional<Scenario> read_scenario(const std::string& path, const Robot& robot, const EmulatedParts& parts,
                                      Duration duration, Sources& sources, Diagnostics& diagnostics);

}  // namespace finemote::gen
