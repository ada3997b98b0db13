// Gives every device and expander on a shared bus its static transfer slot, most urgent first.
#pragma once

#include "generator/schedule/schedule.hpp"

namespace finemote::gen {

/// Slots of the buses that devices reach by one: per physical bus in document order, then rate-monotonic (the bucket of
/// the device; of an expander the fastest bucket that uses it), then schedule order. Needs Schedule::bucket_of. Reports
/// FM3202 when two slots would bear one name.
std::vector<Slot> plan_slots(const Robot& robot, const Forest& forest, const Schedule& schedule,
                             Diagnostics& diagnostics);

}  // namespace finemote::gen
