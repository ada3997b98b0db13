// Robot, forest and schedule to the timing model: costs from the board, frames and acquisition from the descriptors.
#pragma once

#include "generator/forest/forest.hpp"
#include "generator/schedule/schedule.hpp"
#include "generator/tasks/robot_timing_options.hpp"
#include "generator/timing/analyse.hpp"

namespace finemote::gen::timing {

/// What an execution time of a robot rests on. The tag's word `static` is the user's: it is declared.
WcetSource source_of(Wcet::Source source);

/// The model in registration order. Buses are the physical ones that have a rate; costs and interrupts come from
/// the board, frames and acquisition from the device types. `has_target` is set. None where what the board, the types
/// and the robot say adds up to more than 64 bits hold: FM4010 is reported.
std::optional<Model> make_timing_model(const Robot& robot, const Forest& forest, const Schedule& schedule,
                                       Diagnostics& diagnostics, const RobotTimingOptions& options = {});

/// `Robot::requirements` in terms of that model.
std::vector<Requirement> timing_requirements(const Robot& robot, const Forest& forest);

}  // namespace finemote::gen::timing
