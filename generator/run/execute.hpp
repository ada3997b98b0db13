// An executable to the record of its run: natively for the host, in QEMU for the F405.
#pragma once

#include <optional>
#include <string>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/run/record.hpp"

namespace finemote::gen {

/// Runs `program` as built for `board` (host or qemu_f405). Reports FM0006 when the emulator is missing, FM6002 when
/// the firmware stops with a fault or does not end in time, FM6003 when its record cannot be read.
std::optional<RunRecord> execute(const std::string& program, const std::string& board, const Forest& forest,
                                 std::int64_t duration_ns, const FaultTable& faults, Diagnostics& diagnostics);

}  // namespace finemote::gen
