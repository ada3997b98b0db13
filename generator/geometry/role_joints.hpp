// A device and one of its geometry entries to the joints it is computed of.
#pragma once

#include <string>
#include <vector>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// Joints of the children in the entry's role, in their order; empty where there is nothing to compute: no child, or,
/// with an optional entry, none that names a joint. The model has seen to it that otherwise all do.
std::vector<std::string> role_joints(const Robot& robot, const Device& device, const GeometrySpec& geometry);

}  // namespace finemote::gen
