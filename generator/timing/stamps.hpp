// How old data can look: what the firmware dates samples by, where it cannot know when they were taken.
#pragma once

#include "generator/timing/effort.hpp"
#include "generator/timing/task_set.hpp"

namespace finemote::gen::timing {

/// Of every device, by the board's clock; none: there is no bound.
using SampleAges = Table<Rank, std::optional<Duration>>;

/// The ages of samples when update() begins, by their time stamps: more by how much the firmware dates them too early
/// at most. It never dates them too late. Throws Overflow.
/// @param set    of profile `target`, if the model has it
/// @param ages   true ones: WireAnalysis::acquisitions()
/// @param waits  frame_waits() of the model
SampleAges stamped_ages(const Model& model, const TaskSet& set, const SampleAges& ages, const SampleAges& waits,
                        Effort& effort);

}  // namespace finemote::gen::timing
