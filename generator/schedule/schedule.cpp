#include "generator/schedule/schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "generator/bus/bus_type.hpp"
#include "generator/schedule/bindings.hpp"
#include "generator/schedule/slots.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

/// One bucket per period, shortest first, devices in schedule order.
std::vector<Bucket> group_by_period(const Robot& robot, const Forest& forest) {
  std::map<Duration, Bucket> by_period;
  for (DeviceId device : forest.order) {
    const Duration period = robot.devices[device].period;
    Bucket& bucket = by_period[period];
    bucket.period = period;
    bucket.devices.push_back(device);
  }
  std::vector<Bucket> buckets;
  for (auto& [period, bucket] : by_period) {
    bucket.label = units::format_duration(period);
    buckets.push_back(std::move(bucket));
  }
  return buckets;
}

/// Rate-monotonic: the shorter the period, the more urgent the level.
void assign_lines(const Robot& robot, std::vector<Bucket>& buckets, Diagnostics& diagnostics) {
  const Board& board = *robot.board;
  const std::size_t levels = board.last_bucket_level - board.first_bucket_level + 1;
  const std::size_t room = std::min(levels, board.lines.size());
  if (buckets.size() > room) {
    const Device& first_too_many = robot.devices[buckets[room].devices.front()];
    diagnostics
        .error(code::too_many_buckets, first_too_many.period_at,
               fmt::format("{} different periods, but board '{}' can run {}", buckets.size(), board.name, room))
        .note(fmt::format("it has {} spare interrupt lines and {} priority levels for buckets", board.lines.size(),
                          levels))
        .hint("give devices with nearly equal periods the same period");
    return;
  }
  for (std::size_t i = 0; i < buckets.size(); ++i) {
    buckets[i].priority = board.first_bucket_level + static_cast<std::uint32_t>(i);
    buckets[i].line = board.lines[i].number;
  }
}

/// Shared outputs of a bucket: pulse outputs and CAN buses (motors share command frames) its devices write, in document
/// order.
std::vector<SegmentId> shared_outputs(const Robot& robot, const Bucket& bucket) {
  std::set<SegmentId> segments;
  const auto note = [&](std::optional<SegmentId> segment) {
    if (!segment) return;
    if (bus_type(robot.segments[*segment].bus_kind).flush != BusType::Flush::nothing) segments.insert(*segment);
  };
  for (DeviceId device : bucket.devices) {
    note(robot.devices[device].segment);
    for (const Use& use : robot.devices[device].uses) note(use.segment);
  }
  return {segments.begin(), segments.end()};
}

}  // namespace

Schedule plan_schedule(const Robot& robot, const Forest& forest, Diagnostics& diagnostics) {
  Schedule schedule;
  schedule.buckets = group_by_period(robot, forest);
  assign_lines(robot, schedule.buckets, diagnostics);
  schedule.bucket_of.resize(robot.devices.size());
  for (std::size_t i = 0; i < schedule.buckets.size(); ++i) {
    for (DeviceId device : schedule.buckets[i].devices) schedule.bucket_of[device] = i;
    schedule.buckets[i].flushes = shared_outputs(robot, schedule.buckets[i]);
  }
  bind_roles(robot, forest, schedule, diagnostics);
  schedule.slots = plan_slots(robot, forest, schedule, diagnostics);
  return schedule;
}

}  // namespace finemote::gen
