// A routine of a bus of which one run may serve several interrupts: how long each of them takes.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/wcet/causes.hpp"
#include "generator/wcet/prepared_image.hpp"

namespace finemote::gen::wcet {

/// Without faults. However many interrupts come, all runs together take no longer than their sum.
struct EventTimes {
  CauseTimes by_cause;           ///< a request: whatever it hands over
  std::vector<Cycles> requests;  ///< of one that hands over one frame, two, ...; empty: nothing tells them apart
};

/// @param entry        of a routine without a problem
/// @param undisturbed  its ways without faults
EventTimes times_by_event(const PreparedImage& image, std::uint32_t entry, const UnrolledGraph& undisturbed);

/// What each of the interrupts of a cause takes, where a run that serves `k` of them takes `by_served[k]`.
///
/// Besides, a run that serves k may leave k - 1 runs that find nothing left: their interrupts came while it served
/// them. Each k that it serves has to pay for that: the largest of (by_served[k] + (k - 1) by_served[0]) / k.
/// @param by_served  two at least
Cycles time_of_each(const std::vector<Cycles>& by_served);

/// What a frame adds to a run at most, on average over those that the run sends: a run that sends `k` takes
/// `by_served[k]`.
Cycles most_added(const std::vector<Cycles>& by_served);

}  // namespace finemote::gen::wcet
