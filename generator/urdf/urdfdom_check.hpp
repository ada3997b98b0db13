// The second opinion: what urdfdom, which robot_state_publisher and check_urdf use, says of the links and joints.
#pragma once

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/urdf/urdf.hpp"
#include "generator/xml/node.hpp"

namespace finemote::gen {

/// Gives the links and joints to urdfdom and turns its console output into FM2001, located at the element it names.
void check_with_urdfdom(const xml::Node& robot, const Kinematics& kinematics, Diagnostics& diagnostics);

}  // namespace finemote::gen
