// An image to the record of its run on the emulated board.
#pragma once

#include <optional>
#include <string>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/run/phase.hpp"
#include "generator/run/record.hpp"
#include "generator/run/scenario.hpp"
#include "generator/run/silicon.hpp"
#include "generator/run/told_loops.hpp"
#include "generator/schedule/schedule.hpp"

namespace finemote::gen {

struct EmulationOptions {
  const Board& board;                  ///< what is emulated
  const EmulatedParts& parts;          ///< what hangs on it
  const FaultTable& faults;            ///< what the firmware's faults mean
  const std::vector<ToldLoop>& loops;  ///< of the image, whose passes are counted
  const Scenario* scenario = nullptr;  ///< null: none
  const Schedule* audit = nullptr;     ///< not null: every event of a run of this schedule is kept
  std::optional<Phase> phase = {};     ///< none: every clock is exact, and parts begin as their models do
  bool flash_misses = false;   ///< every new line of flash costs its wait states; else the accelerator always has it
  SiliconChoice silicon = {};  ///< which freedom of its manual the chip uses
};

/// Reports FM6012 as a warning for every body whose wheels do not all drive it.
void warn_of_undriven(const EmulatedParts& parts, Diagnostics& diagnostics);

/// Reports FM0010 for every type whose descriptor names a model that the board does not have.
bool has_models(const Robot& robot, Diagnostics& diagnostics);

/// Hangs `parts` and those of the scenario on `board` without an image: what only the wiring shows is
/// reported before anything is compiled, as FM6004, and as FM0010 without a scenario (null). `stem`: of the files it
/// exchanges with the emulator.
bool rehearse(const Board& board, const EmulatedParts& parts, const Scenario* scenario, const std::string& stem,
              Diagnostics& diagnostics);

/// Runs `image` for `duration` from the end of its bring-up on, or until the scenario's last event where that is later,
/// with the robot's parts on the buses. Reports FM6002 when the firmware locks up, resets or ends, FM6005 as a warning
/// for every wrong use of the hardware.
std::optional<RunRecord> emulate(const std::string& image, const Robot& robot, const Forest& forest, Duration duration,
                                 const EmulationOptions& options, Diagnostics& diagnostics);

}  // namespace finemote::gen
