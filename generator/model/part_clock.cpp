#include "generator/model/part_clock.hpp"

#include <algorithm>

#include "generator/model/sample_interval.hpp"
#include "generator/units/clock_tolerance.hpp"

namespace finemote::gen {

std::int64_t board_clock_ppm(const Robot& robot) { return robot.board != nullptr ? robot.board->clock_ppm : 0; }

Duration longest_counted(const Robot& robot, Duration span) { return longest_time(span, board_clock_ppm(robot)); }

Duration shortest_counted(const Robot& robot, Duration span) { return shortest_time(span, board_clock_ppm(robot)); }

Duration longest_of_part(const Robot& robot, const Device& device, Duration span) {
  return longest_counted(robot, longest_time(span, device.type->clock_ppm()));
}

Duration shortest_of_part(const Robot& robot, const Device& device, Duration span) {
  return shortest_counted(robot, shortest_time(span, device.type->clock_ppm()));
}

Duration longest_of_bits(const Robot& robot, const Device& device, Duration span) {
  return longest_counted(robot, longest_time(span, std::min(device.type->clock_ppm(), kMostBitPpm)));
}

Duration shortest_of_bits(const Robot& robot, const Device& device, Duration span) {
  return shortest_counted(robot, shortest_time(span, std::min(device.type->clock_ppm(), kMostBitPpm)));
}

std::optional<Duration> shortest_interval(const Robot& robot, const Device& device, const Frame& frame) {
  const std::optional<Duration> own = frame.min_interval ? frame.min_interval : sample_interval(device);
  if (!own || *own <= Duration::zero()) return std::nullopt;
  return std::max(shortest_of_part(robot, device, *own), nanoseconds(1));
}

}  // namespace finemote::gen
