// Joints of a device's children to what is allowed and rarely meant: FM3163 to FM3168.
#pragma once

#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/model/robot.hpp"

namespace finemote::gen {

/// Warnings at the device's tag, or at that of the child they are about.
std::vector<Diagnostic> joint_findings(const Robot& robot, const Device& device);

}  // namespace finemote::gen
