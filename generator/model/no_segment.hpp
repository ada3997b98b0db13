// The index of what is not there, while a robot is read.
#pragma once

#include <cstddef>

namespace finemote::gen {

/// Segment of an expander whose bus is not there, and physical bus of what such an expander provides. It was reported;
/// no such index is in a robot that was read without an error.
inline constexpr std::size_t kNoSegment = static_cast<std::size_t>(-1);

}  // namespace finemote::gen
