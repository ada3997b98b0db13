// A routine of a bus of which one run may serve several interrupts: how long each of them takes.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/wcet/causes.hpp"
#include "generator/wcet/prepared_image.hpp"

namespace finemote::gen::wcet {

/// By single cause, without faults. However many interrupts come, all runs together take no longer than their sum.
/// @param entry        of a routine without a problem
/// @param undisturbed  its ways without faults
CauseTimes times_by_event(const PreparedImage& image, std::uint32_t entry, const UnrolledGraph& undisturbed);

/// What each of the interrupts of a cause takes, where a run that serves `k` of them takes `by_served[k]`.
///
/// Besides, a run that serves k may leave k - 1 runs that find nothing left: their interrupts came while it served
/// them. Each k that it serves has to pay for that: the largest of (by_served[k] + (k - 1) by_served[0]) / k.
/// @param by_served  two at least
Cycles time_of_each(const std::vector<Cycles>& by_served);

}  // namespace finemote::gen::wcet
