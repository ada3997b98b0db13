// What the compiler is told of a robot beside its generated files.
#pragma once

#include <string>
#include <vector>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// The folders of the robot's own device types.
std::vector<std::string> user_include_dirs(const Robot& robot);

/// Whether its board runs the code in SRAM: param `code`.
bool runs_code_in_sram(const Robot& robot);

}  // namespace finemote::gen
