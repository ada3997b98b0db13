// How many frames of a part that sends by itself one update() may find.
#pragma once

#include <cstdint>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// Frames that arrive while the board counts that long, of a part as fast as it may be, and no more than the longest
/// ring of a serial line keeps; 0 for a device without a type, or of which no part sends by itself.
std::int64_t frames_in(const Robot& robot, const Device& device, Duration window);

/// That one update() handles at most: those that arrive in its period and a quarter of it.
std::int64_t most_frames(const Robot& robot, const Device& device);

/// How long behind its release update() may end while no more than these are waiting for it; any time for a device of
/// which no part sends by itself.
Duration taken_within(const Robot& robot, const Device& device);

/// Line events (idle lines, damaged bytes) that a serial line lets interrupt from one look of its device to the next:
/// the ends of all frames there can be in two periods, answers to its questions among them. 0 for a line that no device
/// is on.
std::int64_t line_events(const Robot& robot, BusId line);

/// Bytes that one update() handles at most of what a serial line has brought: the frames there can be in its period and
/// a quarter of it, answers among them; what the line can bring, or 256, where nobody says what comes.
std::int64_t bytes_at_once(const Robot& robot, BusId line);

/// Bytes that a serial line brings from one look of its device to the next while every job ends in its period: the same
/// of two periods.
std::int64_t received_bytes(const Robot& robot, BusId line);

/// Size of the ring that keeps them: a power of two.
std::int64_t receive_ring(const Robot& robot, BusId line);

}  // namespace finemote::gen
