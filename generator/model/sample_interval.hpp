// How often the part of a device sends its samples, with the params the device has.
#pragma once

#include <optional>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// Nominal time from one sample to the next of a part that sends by itself, by its own clock; none of any other. The
/// device has a type.
std::optional<Duration> sample_interval(const Device& device);

}  // namespace finemote::gen
