// A device and its geometry entries to the joints these are computed of, and to the links whose axes they are in.
#pragma once

#include <string>
#include <vector>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// Joints of the children in the entry's role, in their order; empty where there is nothing to compute: no child, or,
/// with an optional entry, none that names a joint. The model has seen to it that otherwise all do.
std::vector<std::string> role_joints(const Robot& robot, const Device& device, const GeometrySpec& geometry);

/// The link in whose axes a device computes: geometry_link() of the first of its entries that has joints, else its
/// `link` if it is a parent of others; empty: none.
std::string reference_link(const Robot& robot, const Device& device);

/// The link whose axes a part's `mount` takes its data to: reference_link() of the nearest device above it that has
/// one, else of the first that reads it, else Mechanism::body().
std::string mount_link(const Robot& robot, DeviceId device);

}  // namespace finemote::gen
