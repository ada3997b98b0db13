// Stages and jobs of a timeline to the frames they put on the buses.
#pragma once

#include "generator/report/timeline.hpp"

namespace finemote::gen::report {

/// Each transfer at its longest, from when its stage or job has ended on, or, where a part sends by itself, as often as
/// it may. A begun frame ends; then the waiting one of the shortest period is next, and of those the oldest. In the
/// order in which they start, bus after bus.
std::vector<Timeline::Frame> frames_of(const timing::Model& model, const Timeline& timeline);

}  // namespace finemote::gen::report
