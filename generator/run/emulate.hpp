// A Type C image to the record of its run on the emulated board.
#pragma once

#include <optional>
#include <string>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/run/record.hpp"

namespace finemote::gen {

struct EmulationOptions {
  const FaultTable& faults;   ///< what the firmware's faults mean
  std::string scenario;       ///< file; empty: none
  bool flash_misses = false;  ///< every new line of flash costs its wait states; else the accelerator always has it
};

/// Runs `image` for `duration_ns` from its first release on, with the robot's parts on the buses and the events of the
/// scenario file, if any. Reports FM6002 when the firmware locks up, resets or ends, FM6004 for a scenario that cannot
/// be used, at the entry that is wrong (`sources` keeps the file), and FM6005 as a warning for every wrong use of the
/// hardware.
std::optional<RunRecord> emulate(const std::string& image, const Robot& robot, const Forest& forest,
                                 std::int64_t duration_ns, const EmulationOptions& options, Sources& sources,
                                 Diagnostics& diagnostics);

}  // namespace finemote::gen
