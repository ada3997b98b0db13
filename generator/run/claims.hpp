// Whether devices say of their data what is true: how much fresher their time stamps claim they are.
#pragma once

#include <vector>

#include "generator/run/measured.hpp"

namespace finemote::gen {

/// What the time stamp of a state may claim too much: the clock of the firmware counts in steps below that.
inline constexpr Duration kClaimSlack = microseconds(1);

struct MeasuredClaim {
  DeviceId device;
  Measured lead;  ///< claimed origin less the time when the oldest sample in the state was taken; bound: kClaimSlack
};

/// Of devices with a sensor of their own, at the end of every update after the bring-up that left a valid state.
std::vector<MeasuredClaim> measure_claims(const Robot& robot, const Forest& forest, const RunRecord& record);

}  // namespace finemote::gen
