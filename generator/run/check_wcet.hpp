// Holds the execution times the analysis was given against those of a run.
#pragma once

#include <cstdint>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/run/record.hpp"

namespace finemote::gen {

/// Warns (FM6006) of every device of which even the shortest run of a stage took longer than its WCET and
/// `stage_cost_ns`, what the model adds for dispatch and trace: bounds made from that WCET are not proven. Time of
/// stages that interrupted it does not count; interrupts of buses do, therefore the shortest run is asked.
void check_wcet(const Robot& robot, const RunRecord& record, std::int64_t stage_cost_ns, Diagnostics& diagnostics);

}  // namespace finemote::gen
