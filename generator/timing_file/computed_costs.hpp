// Bounds of what runs around the stages to those of a robot.
#pragma once

#include <optional>

#include "generator/model/robot.hpp"
#include "generator/timing_file/timing_file.hpp"

namespace finemote::gen {

/// None where the file lacks some of them: a robot is charged with bounds alone, or with what its board file says.
std::optional<ComputedCosts> computed_costs(const TimingFile& file, const Robot& robot);

}  // namespace finemote::gen
