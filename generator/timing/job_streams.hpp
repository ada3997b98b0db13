// Interrupts in the windows of jobs: fewer than in any window, because most of what causes them does not run there.
#pragma once

#include "generator/timing/response.hpp"

namespace finemote::gen::timing {

/// The task set of profile `target`, whose streams know which job causes what: `of_jobs` and `ended` are filled, and
/// budgets whose transfers end within their period go without the further jobs that are counted otherwise.
///
/// A window of a job begins when nothing of higher priority waits: before its release, or in the job itself. From then
/// on until the job has come to its place, only the job, higher-priority jobs released meanwhile, and interrupts run;
/// of the job only its stages up to that place.
/// So the interrupts are of three kinds:
/// - requests run at once when a stage or a flush asks: those of the jobs and stages that run in the window, and one
///   that a lower-priority job had asked for with interrupts masked, where the window does not begin in the job;
/// - transfers go on after the stage that asked for them: besides, those of jobs whose transfers may not have ended
///   when the window begins;
/// - looks allow interrupts until the next look: those left when the window begins, and those that looks in it allow.
///
/// @param responses  bounds that hold already, with the streams of any window or of an earlier call; from them follows
///                   when transfers have ended
/// @param effort     for the search of when they have; where it does not suffice, any window's streams stay
void separate_jobs(const Model& model, const Responses& responses, TaskSet& set, Effort& effort);

}  // namespace finemote::gen::timing
