// How long the part of a device measures, with the params the device has.
#pragma once

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// The longest conversion, as the descriptor gives it for the device's params; 0 where it speaks of none, or the
/// part sends by itself.
Duration conversion_time(const Device& device);

}  // namespace finemote::gen
