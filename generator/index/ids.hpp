// The index spaces of a robot: which device, bus, segment or expander of it, and where a device stands in the order.
#pragma once

#include "generator/index/index.hpp"

namespace finemote::gen {

using DeviceId = Index<struct DeviceSpace>;      ///< of Robot::devices: document order of start tags
using BusId = Index<struct BusSpace>;            ///< of Robot::buses
using SegmentId = Index<struct SegmentSpace>;    ///< of Robot::segments: whatever `bus=` can name
using ExpanderId = Index<struct ExpanderSpace>;  ///< of Robot::expanders

/// Position of a device in the order everything runs in, of Forest::order and timing::Model: children before parents.
using Rank = Index<struct RankSpace>;

}  // namespace finemote::gen
