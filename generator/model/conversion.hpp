// How long the part of a device measures, with the params the device has.
#pragma once

#include <cstdint>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// The longest conversion [ns], as the descriptor gives it for the device's params; 0 where it speaks of none, or the
/// part sends by itself.
std::int64_t conversion_ns(const Device& device);

}  // namespace finemote::gen
