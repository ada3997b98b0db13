// Params of a device type or board to a table of its reference page.
#pragma once

#include <string>
#include <vector>

#include "generator/descriptor/device_type.hpp"

namespace finemote::gen {

/// `## Parameters` with a row for each; empty where there are none.
std::string param_table(const std::vector<ParamSpec>& params);

}  // namespace finemote::gen
