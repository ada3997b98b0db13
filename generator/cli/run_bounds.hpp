// Whether a saved run was judged by the bounds that a robot has now.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen {

/// Reports (FM6016, a warning) where it was not: robot, types or options have changed since.
/// @param run     what `finemote run` printed, read from `path`; null: there is none
/// @param timing  what `finemote analyze` prints of the robot now
void check_bounds_of_run(const nlohmann::ordered_json& run, const std::string& path,
                         const nlohmann::ordered_json& timing, Diagnostics& diagnostics);

}  // namespace finemote::gen
