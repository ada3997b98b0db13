// An executable to the record of its run: on this computer, or in QEMU for the board it emulates.
#pragma once

#include <optional>
#include <string>

#include "generator/descriptor/board.hpp"
#include "generator/diagnostic/diagnostics.hpp"
#include "generator/run/record.hpp"

namespace finemote::gen {

/// Runs `program` as built for `board`, which stands in for others. Reports FM0006 when the emulator is missing, FM6002
/// when the firmware ends by itself or not in time, FM6003 when its record cannot be read. A safe stop is in the
/// record.
std::optional<RunRecord> execute(const std::string& program, const Board& board, const Robot& robot,
                                 const Forest& forest, Duration duration, const FaultTable& faults,
                                 Diagnostics& diagnostics);

}  // namespace finemote::gen
