// Counts what publishes a value with the stage that makes it.
#pragma once

#include "generator/forest/forest.hpp"
#include "generator/model/robot.hpp"
#include "generator/schedule/schedule.hpp"
#include "generator/timing/model.hpp"

namespace finemote::gen::timing {

/// A faster bucket finds a value once it is published, which the job does between the stage that makes it and the next
/// one. Computed costs have what runs there with the latter: it counts with the former here, so that the response time
/// of a stage is when its value is there.
/// @param model  of a robot with computed costs, its devices complete
void charge_publishing(const Robot& robot, const Forest& forest, const Schedule& schedule, Model& model);

}  // namespace finemote::gen::timing
