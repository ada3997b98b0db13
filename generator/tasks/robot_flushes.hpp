// Shared outputs of a robot to the flushes of the timing model: who fills them, and what they send.
#pragma once

#include "generator/schedule/schedule.hpp"
#include "generator/tasks/traffic.hpp"

namespace finemote::gen::timing {

/// Adds the flushes of every bucket, and their budgets, to a model whose buses and devices are complete.
void add_flushes(const Robot& robot, const Forest& forest, const Schedule& schedule, const BusPlaces& places,
                 Traffic& traffic, Model& model);

}  // namespace finemote::gen::timing
