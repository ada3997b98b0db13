// Figures of a device type without which a bound would be missing or too short.
#pragma once

#include "generator/descriptor/contradictions.hpp"
#include "generator/descriptor/device_type.hpp"

namespace finemote::gen {

/// Reports an acquisition without the figures of its model or with those of the other, a conversion that is not given
/// for every value of its param, and frames and interrupts that come by themselves at any rate.
void check_timing_figures(const DeviceType& type, const Contradictions& found);

}  // namespace finemote::gen
