// The lines that a firmware prints, to the record of its run.
#pragma once

#include <optional>
#include <string>

#include "generator/run/record.hpp"

namespace finemote::gen {

/// Reads the lines the firmware prints: `E <ns> <stage> B|E`, `O <bucket> <count>`, `B <bus> <transfers> <errors> <busy
/// ns>`, `F <module> <number> <count>`, `S <ns>`, `M <device> <worst response> <worst age> <late> <old>`; other lines
/// are ignored. None when a line is broken, there is no such stage, or bus of so many, or a time is beyond 1000 days.
std::optional<RunRecord> parse_record(const std::string& text, const Forest& forest, std::size_t buses,
                                      Duration duration);

}  // namespace finemote::gen
