// The raw record of a run as JSON Lines: docs/reference/audit.md.
#pragma once

#include <string>

#include "generator/run/record.hpp"
#include "generator/schedule/schedule.hpp"

namespace finemote::gen {

/// Which run a record is of.
struct AuditedRun {
  std::string image_sha256;
  std::uint64_t seed = 0;
  std::uint64_t phase = 0;
};

/// One line that says what the numbers stand for, then the events in the order of time.
std::string audit_lines(const Robot& robot, const Forest& forest, const Schedule& schedule, const AuditedRun& run,
                        const RunRecord& record);

}  // namespace finemote::gen
