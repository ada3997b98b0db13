// A node on a CAN bus that no robot declares: sends a number of frames of one identifier.
#pragma once

#include "emulator/chip/can_line.hpp"

namespace finemote::emulator {

struct ForeignFrames {
  std::uint32_t identifier = 0;
  unsigned count = 1;
  Time apart = 0;  ///< from one to the next; what the wire does not take in time is sent later
};

/// The frames have eight bytes, the longest there are.
void flood(World& world, CanLine& line, const ForeignFrames& frames);

}  // namespace finemote::emulator
