// Rules about pins and outputs of the board that a robot uses for what they are not made for.
#pragma once

#include "generator/lint/rule.hpp"

namespace finemote::gen {

/// FM3208: a pin that leads to no connector of the board, and an output that drives something else than what the device
/// is for.
void find_odd_outputs(const Robot& robot, Findings& findings);

}  // namespace finemote::gen
