// Binds every role of every device to its children and observed devices, and finds the crossings between buckets.
#pragma once

#include "generator/schedule/schedule.hpp"

namespace finemote::gen {

/// Fills Schedule::roles and Schedule::crossings; needs Schedule::bucket_of.
void bind_roles(const Robot& robot, const Forest& forest, Schedule& schedule, Diagnostics& diagnostics);

}  // namespace finemote::gen
