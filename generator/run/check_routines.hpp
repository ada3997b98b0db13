// Holds the execution times of interrupt routines that the analysis counts against those of a run.
#pragma once

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/run/record.hpp"
#include "generator/timing/model.hpp"

namespace finemote::gen {

/// Reports (FM6006) every bus of which a run of a service routine took longer by itself than its `isr_wcet` says or,
/// without one, than the analysis counts; the release interrupt likewise; and the pins of which one took longer than
/// the types of all devices on them say together, whose edges it may have served at once. Where a scenario, or a flash
/// that always misses, violates an assumption, only what the robot declares is looked at.
/// @param model  that the bounds are made of
/// @return  whether there is none
bool check_routines(const Robot& robot, const timing::Model& model, const RunRecord& record, Diagnostics& diagnostics);

}  // namespace finemote::gen
