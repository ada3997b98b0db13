// What a run has shown of stages, chains and responses; the figures of several runs together.
#pragma once

#include <array>
#include <vector>

#include "generator/run/chains.hpp"
#include "generator/run/claims.hpp"
#include "generator/run/pin_lines.hpp"
#include "generator/run/responses.hpp"
#include "generator/run/traffic.hpp"

namespace finemote::gen {

struct RunFigures {
  Table<DeviceId, std::array<Statistics, 2>> stages;  ///< begin to end of update() and of handle(), preemption included
  std::vector<MeasuredChain> chains;
  std::vector<MeasuredResponse> responses;  ///< empty where nothing is held to bounds
  std::vector<MeasuredClaim> claims;        ///< the same
  std::vector<MeasuredTraffic> traffic;     ///< the same
  std::vector<MeasuredPins> pins;           ///< the same
};

/// Of one run, from the end of its bring-up on.
/// @param timing    what it is held to; null: no answer, so neither chains nor responses
/// @param is_bound  the bounds hold for what ran
RunFigures figures_of(const Robot& robot, const Forest& forest, const Schedule& schedule, const timing::Timing* timing,
                      const RunRecord& record, bool is_bound);

/// Adds another run of the same image.
void merge(RunFigures& all, const RunFigures& more);

}  // namespace finemote::gen
