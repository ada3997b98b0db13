// The CAN frames of a device type: identifiers it receives, and frames it shares with others.
#pragma once

#include "generator/descriptor/contradictions.hpp"
#include "generator/descriptor/device_type.hpp"

namespace finemote::gen {

/// Reports identifiers that no filter accepts, that have more than 11 bits or that two entries of one device have;
/// frames that a part sends by itself and nobody receives; and shared frames too small for the ids they are for or that
/// share an id.
void check_can_frames(const DeviceType& type, const Contradictions& found);

}  // namespace finemote::gen
