// The indices of what is not there, while a robot is read.
#pragma once

#include "generator/index/ids.hpp"

namespace finemote::gen {

/// Segment of an expander whose bus is not there, and physical bus of what such an expander provides. It was reported;
/// no such index is in a robot that was read without an error.
inline constexpr SegmentId kNoSegment{static_cast<std::size_t>(-1)};
inline constexpr BusId kNoBus{static_cast<std::size_t>(-1)};

}  // namespace finemote::gen
