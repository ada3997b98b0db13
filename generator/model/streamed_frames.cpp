#include "generator/model/streamed_frames.hpp"

#include <algorithm>

#include "generator/bus/bus_type.hpp"
#include "generator/descriptor/runtime_limits.hpp"
#include "generator/model/connection.hpp"
#include "generator/model/part_clock.hpp"

namespace finemote::gen {
namespace {

std::int64_t frames_in(const Robot& robot, const Device& device, const Frame& frame, Duration window) {
  const std::int64_t kept = runtime_limits::kMostReceiveRing / std::max<std::int64_t>(frame.read_bytes, 1) + 1;
  const std::optional<Duration> interval = shortest_interval(robot, device, frame);
  return interval ? std::min(floor_div(window, *interval) + 1, kept) : kept;
}

/// Over all frames that a part of the device sends by itself.
template <typename Count>
std::int64_t sum_over_streams(const Device& device, const Count& count) {
  std::int64_t sum = 0;
  if (device.type == nullptr || !device.type->frames) return sum;
  for (const Frame& frame : *device.type->frames) {
    if (frame.stage == FrameStage::autonomous) sum += count(frame);
  }
  return sum;
}

/// Of what the device itself asks for over a serial line, at most once in a job: two periods hold three jobs.
template <typename Count>
std::int64_t sum_over_answers(const Robot& robot, const Device& device, BusId line, const Count& count) {
  constexpr std::int64_t kJobs = 3;
  std::int64_t sum = 0;
  if (device.type == nullptr) return sum;
  for (const Connection& connection : connections_of(device)) {
    if (robot.segments[connection.segment].bus != line) continue;
    for (const Frame& frame : frames_over(device, connection)) {
      const bool is_answered = frame.stage != FrameStage::autonomous && frame.read_bytes > 0;
      if (is_answered) sum += kJobs * count(frame);
    }
  }
  return sum;
}

/// From one look of update() to the next while every job ends in its period.
Duration longest_look(const Device& device) {
  return device.period > floor_div(Duration::max(), 2) ? Duration::max() : 2 * device.period;
}

/// Of the devices on a line: what is usual for one whose count is 0, and 0 without any.
template <typename Usual, typename Count>
std::int64_t most_on_line(const Robot& robot, BusId line, const Usual& usual, const Count& count) {
  const auto is_there = [&](const Connection& connection) { return robot.segments[connection.segment].bus == line; };
  std::int64_t most = 0;
  for (const Device& device : robot.devices) {
    const std::vector<Connection> connections = connections_of(device);
    if (std::none_of(connections.begin(), connections.end(), is_there)) continue;
    const std::int64_t counted = count(device);
    most = std::max(most, counted > 0 ? counted : usual(device));
  }
  return most;
}

/// Of a part of which nobody says what it sends: all that the line can bring meanwhile, within reason.
std::int64_t usual_bytes(const Bus& line, Duration window) {
  constexpr std::int64_t kLeast = 256, kMost = 1024, kBitsPerByte = 10;
  if (!bus_type(line.kind).has_two_lines) return kLeast;  // parts answer only
  const Duration most_counted = seconds(1);
  const std::int64_t bytes = floor_div(std::min(window, most_counted) * line.rate, seconds(kBitsPerByte)) + 1;
  return std::clamp(bytes, kLeast, kMost);
}

}  // namespace

std::int64_t frames_in(const Robot& robot, const Device& device, Duration window) {
  return sum_over_streams(device, [&](const Frame& frame) { return frames_in(robot, device, frame, window); });
}

std::int64_t line_events(const Robot& robot, BusId line) {
  const auto usual = [](const Device&) { return std::int64_t{16}; };  // nobody says what the part sends
  return most_on_line(robot, line, usual, [&](const Device& device) {
    return most_frames(robot, device) + sum_over_answers(robot, device, line, [](const Frame&) { return 1; });
  });
}

std::int64_t received_bytes(const Robot& robot, BusId line) {
  const auto usual = [&](const Device& device) { return usual_bytes(robot.buses[line], longest_look(device)); };
  return most_on_line(robot, line, usual, [&](const Device& device) {
    const std::int64_t streamed = sum_over_streams(device, [&](const Frame& frame) {
      return frames_in(robot, device, frame, longest_look(device)) * frame.read_bytes;
    });
    return streamed + sum_over_answers(robot, device, line, [](const Frame& frame) { return frame.read_bytes; });
  });
}

std::int64_t receive_ring(const Robot& robot, BusId line) {
  std::int64_t size = runtime_limits::kLeastReceiveRing;
  const std::int64_t needed = std::min(received_bytes(robot, line), runtime_limits::kMostReceiveRing);
  while (size < needed) size *= 2;
  return size;
}

std::int64_t most_frames(const Robot& robot, const Device& device) {
  return frames_in(robot, device, longest_look(device));
}

}  // namespace finemote::gen
