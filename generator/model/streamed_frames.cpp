#include "generator/model/streamed_frames.hpp"

#include <algorithm>

#include "generator/bus/line_format.hpp"
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

/// The same while it ends within a quarter of it: what one update() handles. What comes in a longer one waits for the
/// next update(), which is rare, and in the bounds (taken_within).
Duration usual_look(const Device& device) {
  return device.period > floor_div(Duration::max(), 2) ? Duration::max() : device.period + floor_div(device.period, 4);
}

/// Over the devices on a line, 0 without any: the largest of what `count` says for one and where it hangs on the line.
template <typename Count>
std::int64_t most_on_line(const Robot& robot, BusId line, const Count& count) {
  const auto is_there = [&](const Connection& connection) { return robot.segments[connection.segment].bus == line; };
  std::int64_t most = 0;
  for (const Device& device : robot.devices) {
    const std::vector<Connection> connections = connections_of(device);
    const auto own = std::find_if(connections.begin(), connections.end(), is_there);
    if (own != connections.end()) most = std::max(most, count(device, *own));
  }
  return most;
}

/// Bytes that a line can bring while the board counts that long, where nobody says what it brings: `kUsual` of them at
/// most, of a sender that is 5 % too fast.
std::int64_t usual_bytes(const Robot& robot, BusId line, const LineFormat& format, Duration window) {
  constexpr std::int64_t kUsual = 256, kPercent = 105;
  if (window > seconds(1)) return kUsual;
  const std::int64_t bits = robot.buses[line].rate * kPercent / 100 + 1;  // per second
  const std::int64_t bytes = window.ns() / format.bits_per_byte() * bits / seconds(1).ns() + 2;
  return std::min(bytes, kUsual);
}

/// Bytes that a line brings from one look of its device to the next, where two looks are `look(device)` apart at most.
template <typename Look>
std::int64_t line_bytes(const Robot& robot, BusId line, const Look& look) {
  return most_on_line(robot, line, [&](const Device& device, const Connection& connection) {
    const std::int64_t streamed = sum_over_streams(
        device, [&](const Frame& frame) { return frames_in(robot, device, frame, look(device)) * frame.read_bytes; });
    const std::int64_t declared =
        streamed + sum_over_answers(robot, device, line, [](const Frame& frame) { return frame.read_bytes; });
    const LineFormat format = device.type == nullptr ? LineFormat{} : line_format(format_over(device, connection));
    return declared > 0 ? declared : usual_bytes(robot, line, format, look(device));
  });
}

}  // namespace

std::int64_t frames_in(const Robot& robot, const Device& device, Duration window) {
  return sum_over_streams(device, [&](const Frame& frame) { return frames_in(robot, device, frame, window); });
}

std::int64_t line_events(const Robot& robot, BusId line) {
  constexpr std::int64_t kUsual = 16;  // of a part of which nobody says what it sends
  return most_on_line(robot, line, [&](const Device& device, const Connection&) {
    const std::int64_t declared = frames_in(robot, device, longest_look(device)) +
                                  sum_over_answers(robot, device, line, [](const Frame&) { return 1; });
    return declared > 0 ? declared : kUsual;
  });
}

std::int64_t bytes_at_once(const Robot& robot, BusId line) { return line_bytes(robot, line, usual_look); }

std::int64_t received_bytes(const Robot& robot, BusId line) { return line_bytes(robot, line, longest_look); }

std::int64_t receive_ring(const Robot& robot, BusId line) {
  std::int64_t size = runtime_limits::kLeastReceiveRing;
  const std::int64_t needed = std::min(received_bytes(robot, line), runtime_limits::kMostReceiveRing);
  while (size < needed) size *= 2;
  return size;
}

std::int64_t most_frames(const Robot& robot, const Device& device) {
  return frames_in(robot, device, usual_look(device));
}

Duration taken_within(const Robot& robot, const Device& device) {
  Duration least = Duration::max();
  if (device.type == nullptr || !device.type->frames) return least;
  for (const Frame& frame : *device.type->frames) {
    const auto interval =
        frame.stage == FrameStage::autonomous ? shortest_interval(robot, device, frame) : std::nullopt;
    if (!interval) continue;
    const std::int64_t taken = frames_in(robot, device, frame, usual_look(device));
    const Duration longest = taken * *interval - nanoseconds(1);  // of a window with no more frames in it
    least = std::min(least, std::max(longest - device.period, Duration::zero()));
  }
  return least;
}

}  // namespace finemote::gen
