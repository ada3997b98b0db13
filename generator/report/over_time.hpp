// What a run has seen over time to plots: quantities of the robot's parts, and how old commands were.
#pragma once

#include <string>

#include "generator/report/documents.hpp"

namespace finemote::gen::report {

/// Plots, and a table of what they show. Empty without a run, or where it holds no series.
std::string over_time(const Documents& documents);

}  // namespace finemote::gen::report
