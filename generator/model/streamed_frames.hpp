// How many frames of a part that sends by itself one update() may find.
#pragma once

#include <cstdint>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// Frames that arrive while the board counts that long, of a part as fast as it may be, and no more than the longest
/// ring of a serial line keeps; 0 for a device without a type, or of which no part sends by itself.
std::int64_t frames_in(const Robot& robot, const Device& device, Duration window);

/// The longest window between two looks of update() while every job ends in its period: two periods.
std::int64_t most_frames(const Robot& robot, const Device& device);

/// Line events (idle lines, damaged bytes) that a serial line lets interrupt from one look of its device to the next:
/// the ends of all frames there can be in two periods, answers to its questions among them. 0 for a line that no device
/// is on.
std::int64_t line_events(const Robot& robot, BusId line);

/// Bytes that a serial line brings from one look of its device to the next: the frames there can be in two periods,
/// answers among them. Where nobody says what comes, what the line can bring, 256 at least and 1024 at most.
std::int64_t received_bytes(const Robot& robot, BusId line);

/// Size of the ring that keeps them: a power of two.
std::int64_t receive_ring(const Robot& robot, BusId line);

}  // namespace finemote::gen
