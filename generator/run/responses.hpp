// How late stages ended after the releases of their jobs, beside the bounds.
#pragma once

#include <array>
#include <vector>

#include "generator/run/measure.hpp"
#include "generator/run/measured.hpp"
#include "generator/schedule/schedule.hpp"
#include "generator/timing/analyse.hpp"

namespace finemote::gen {

struct MeasuredResponse {
  DeviceId device;
  Measured update, handle;  ///< release to end
  Measured jitter;          ///< of the end of handle(): one sample, the latest less the earliest
};

inline constexpr std::array<Figure<MeasuredResponse>, 3> kResponseFigures{{{"update", &MeasuredResponse::update},
                                                                           {"handle", &MeasuredResponse::handle},
                                                                           {"jitter", &MeasuredResponse::jitter}}};

/// Of every device and every job after the bring-up, in the order of `forest`. Every release has its job, so one that
/// is lost makes all jobs after it late; where overruns were counted or the board began anew, a stage belongs to the
/// last release before it began.
std::vector<MeasuredResponse> measure_responses(const Robot& robot, const Forest& forest, const Schedule& schedule,
                                                const timing::Timing& timing, const RunRecord& record,
                                                const StageRuns& runs);

}  // namespace finemote::gen
