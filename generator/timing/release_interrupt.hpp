// Whether releases can be lost: a timer that keeps one release that waits for its interrupt needs it to end in time.
#pragma once

#include <optional>

#include "generator/timing/effort.hpp"
#include "generator/timing/model.hpp"
#include "generator/timing/result.hpp"
#include "generator/timing/task_set.hpp"

namespace finemote::gen::timing {

/// Response time of the release interrupt, and the time that it has; none where nothing can be lost. Interrupts of
/// buses have a higher priority. Throws Overflow.
///
/// A release that is through before the next one comes has left nothing of higher priority behind, so that every
/// release is the first one of its busy window: R = blocking + cost + demand of the buses in R bounds all of them.
std::optional<ReleaseResult> bound_release(const Model& model, const TaskSet& set, Effort& effort);

}  // namespace finemote::gen::timing
