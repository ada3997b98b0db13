// Changes of a robot's description to the timing model it then has.
#pragma once

#include "generator/tasks/from_robot.hpp"
#include "generator/timing/change.hpp"

namespace finemote::gen::timing {

/// Makes the models of the robot with changes, as if they were written into its file: a device below one whose period
/// changes follows unless it has a period of its own. Robot and forest must outlive the result.
Remodel robot_remodel(const Robot& robot, const Forest& forest, const RobotTimingOptions& options = {});

}  // namespace finemote::gen::timing
