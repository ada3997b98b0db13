// What follows from a robot, as facts that `finemote diff` compares: proven bounds, and sizes of what is generated.
#pragma once

#include "generator/cli/diff_facts.hpp"

namespace finemote::gen {

void add_bounds(const Analysis& analysis, Facts& facts);

void add_sizes(const PlannedRobot& planned, const std::vector<OutputFile>& files, Facts& facts);

}  // namespace finemote::gen
