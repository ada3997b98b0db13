#include "generator/model/streamed_frames.hpp"

#include <algorithm>

#include "generator/descriptor/runtime_limits.hpp"
#include "generator/model/part_clock.hpp"

namespace finemote::gen {
namespace {

std::int64_t frames_in(const Robot& robot, const Device& device, const Frame& frame, Duration window) {
  const std::int64_t kept = runtime_limits::kReceiveRingBytes / std::max<std::int64_t>(frame.read_bytes, 1) + 1;
  const std::optional<Duration> interval = shortest_interval(robot, device, frame);
  return interval ? std::min(floor_div(window, *interval) + 1, kept) : kept;
}

}  // namespace

std::int64_t frames_in(const Robot& robot, const Device& device, Duration window) {
  std::int64_t sum = 0;
  if (device.type == nullptr || !device.type->frames) return sum;
  for (const Frame& frame : *device.type->frames) {
    if (frame.stage == FrameStage::autonomous) sum += frames_in(robot, device, frame, window);
  }
  return sum;
}

std::int64_t line_events(const Robot& robot, BusId line) {
  constexpr std::int64_t kUsual = 16;  // of a part of which nobody says what it sends
  const auto is_there = [&](std::optional<SegmentId> segment) {
    return segment && robot.segments[*segment].bus == line;
  };
  std::int64_t most = 0;
  for (const Device& device : robot.devices) {
    const bool uses =
        std::any_of(device.uses.begin(), device.uses.end(), [&](const Use& use) { return is_there(use.segment); });
    if (!uses && !is_there(device.segment)) continue;
    const std::int64_t frames = most_frames(robot, device);
    most = std::max(most, frames > 0 ? frames : kUsual);
  }
  return most;
}

std::int64_t most_frames(const Robot& robot, const Device& device) {
  if (device.period > floor_div(Duration::max(), 2)) return frames_in(robot, device, Duration::max());
  return frames_in(robot, device, 2 * device.period);
}

}  // namespace finemote::gen
