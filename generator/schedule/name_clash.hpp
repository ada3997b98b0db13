// Two parts of generated code that would have one name: FM3202.
#pragma once

#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/model/robot.hpp"

namespace finemote::gen {

/// Reports that the name generated for a device is the one these have already.
void report_name_clash(const std::string& name, const Device& device, const std::vector<const Device*>& holders,
                       Diagnostics& diagnostics);

}  // namespace finemote::gen
