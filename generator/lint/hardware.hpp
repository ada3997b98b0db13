// Pins and outputs of the board that a robot uses for what they are not made for.
#pragma once

#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/model/robot.hpp"

namespace finemote::gen {

/// FM3208, as warnings: a pin that leads to no connector of the board, and an output that drives something else than
/// what the device is for.
std::vector<Diagnostic> hardware_findings(const Robot& robot);

}  // namespace finemote::gen
