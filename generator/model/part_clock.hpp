// Times that a part keeps by its own clock to what the board's clock can count meanwhile: both may be off.
#pragma once

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// How far the board's clock may be off, both ways [ppm]; 0 without a board.
std::int64_t board_clock_ppm(const Robot& robot);

/// What the board counts while something takes `span` of true time: at most and at least.
Duration longest_counted(const Robot& robot, Duration span);
Duration shortest_counted(const Robot& robot, Duration span);

/// The same of a part with a clock of its own, which takes it for `span`. The device has a type.
Duration longest_of_part(const Robot& robot, const Device& device, Duration span);
Duration shortest_of_part(const Robot& robot, const Device& device, Duration span);

/// The same of bits that it sends: a sender whose bits are further off than kMostBitPpm is not understood, however
/// irregular the times are when it sends. RM0090 30.3.5: 3.75 %, less with a fraction in the divider.
inline constexpr std::int64_t kMostBitPpm = 37'500;
Duration longest_of_bits(const Robot& robot, const Device& device, Duration span);
Duration shortest_of_bits(const Robot& robot, const Device& device, Duration span);

/// From one frame to the next of those that a part sends by itself, as the board counts it: at least so long, 1 ns or
/// more. None where its descriptor does not say. The device has a type.
std::optional<Duration> shortest_interval(const Robot& robot, const Device& device, const Frame& frame);

}  // namespace finemote::gen
