// Rules about joints that <ros2_control> commands and a device drives.
#pragma once

#include "generator/lint/rule.hpp"

namespace finemote::gen {

/// FM3169, at the joint in <ros2_control>: what it is commanded there is not what its device takes.
void find_other_commands(const Robot& robot, Findings& findings);

}  // namespace finemote::gen
