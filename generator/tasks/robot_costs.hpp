// What the processor and the runtime themselves cost a robot: from the costs of its board and the shape of its
// schedule.
#pragma once

#include "generator/schedule/schedule.hpp"
#include "generator/tasks/robot_timing_options.hpp"
#include "generator/timing/model.hpp"

namespace finemote::gen::timing {

/// All zero for a robot without a board.
Costs robot_costs(const Robot& robot, const Schedule& schedule, const RobotTimingOptions& options);

/// What the monitor costs, where it is built in: an estimate where the board does not say.
Duration monitor_cost(std::optional<Duration> of_board);

/// One check of every bus that the runtime supervises, at the start of every job of the fastest bucket; for buses that
/// work: one that is being recovered takes longer (docs/timing.md, assumptions).
Duration supervision(const Robot& robot);

/// Costs of the board; zero for a robot without one.
const gen::Costs& board_costs(const Robot& robot);

}  // namespace finemote::gen::timing
