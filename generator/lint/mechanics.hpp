// A device's geometry to what is allowed and rarely meant: FM3158, FM3159, FM3160.
#pragma once

#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/model/robot.hpp"

namespace finemote::gen {

/// Warnings at the device's tag. Of an allocation: axes of the wrench the device commands that its actuators do not
/// produce within the tolerance (FM3158), or only with many times the force (FM3159). Of a range: limits of the joint
/// that the travel does not reach (FM3160).
std::vector<Diagnostic> mechanics_findings(const Robot& robot, const Device& device);

}  // namespace finemote::gen
