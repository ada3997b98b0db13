// Whether devices say of their data what is true, and still use them when they say themselves that they are too old.
#pragma once

#include <array>
#include <vector>

#include "generator/run/measure.hpp"
#include "generator/run/measured.hpp"
#include "generator/timing/analyse.hpp"

namespace finemote::gen {

/// What the time stamp of a state may claim too much: the clock of the firmware counts in steps below that.
inline constexpr Duration kClaimSlack = microseconds(1);

struct MeasuredClaim {
  DeviceId device;
  Measured lead;  ///< claimed origin less the time when the oldest sample in the state was taken; bound: kClaimSlack
  Measured age;   ///< of data that are said to be valid, by their claim, when update() starts
};

inline constexpr std::array<Figure<MeasuredClaim>, 2> kClaimFigures{
    {{"lead", &MeasuredClaim::lead}, {"age", &MeasuredClaim::age}}};

/// Of devices with a sensor of their own, at the end of every update after the bring-up that left a valid state.
std::vector<MeasuredClaim> measure_claims(const Robot& robot, const Forest& forest, const timing::Timing& timing,
                                          const RunRecord& record, const StageRuns& runs);

}  // namespace finemote::gen
