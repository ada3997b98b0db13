#include "generator/run/measure.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>

namespace finemote::gen {
namespace {

struct Interval {
  Duration begin, end;
};

/// Completed runs of a stage, in time order.
std::vector<Interval> intervals(const RunRecord& record, DeviceId device, bool is_handle) {
  std::vector<Interval> list;
  std::optional<Duration> begin;  // none: it does not run
  for (const Event& event : record.events) {
    if (event.device != device || event.is_handle != is_handle) continue;
    if (event.is_end && begin) list.push_back({*begin, event.at});
    begin = event.is_end ? std::nullopt : std::optional(event.at);
  }
  return list;
}

/// The last run that was finished at `time`.
const Interval* finished_by(const std::vector<Interval>& runs, Duration time) {
  const auto after =
      std::upper_bound(runs.begin(), runs.end(), time, [](Duration t, const Interval& run) { return t < run.end; });
  return after == runs.begin() ? nullptr : &*std::prev(after);
}

/// For every device that data of `from` reaches upward: the device it came from. Breadth first, so ways are shortest.
std::map<DeviceId, DeviceId> reached_upward(const Robot& robot, DeviceId from, bool over_reads) {
  std::map<DeviceId, DeviceId> came_from{{from, from}};
  std::deque<DeviceId> queue{from};
  const auto visit = [&](DeviceId next, DeviceId previous) {
    if (came_from.emplace(next, previous).second) queue.push_back(next);
  };
  while (!queue.empty()) {
    const DeviceId device = queue.front();
    queue.pop_front();
    if (robot.devices[device].parent) visit(*robot.devices[device].parent, device);
    if (!over_reads) continue;
    for (const DeviceId reader : robot.devices.ids()) {
      for (const Read& read : robot.devices[reader].reads) {
        if (read.device == device) visit(reader, device);
      }
    }
  }
  return came_from;
}

std::optional<ChainPath> find_way(const Robot& robot, DeviceId from, DeviceId to, bool over_reads) {
  const auto came_from = reached_upward(robot, from, over_reads);
  ChainPath path;
  path.through_reads = over_reads;
  for (std::optional<DeviceId> turn = to; turn; turn = robot.devices[*turn].parent) {
    path.down.insert(path.down.begin(), *turn);
    if (came_from.count(*turn) == 0) continue;
    for (DeviceId device = *turn;; device = came_from.at(device)) {
      path.up.insert(path.up.begin(), device);
      if (device == from) return path;
    }
  }
  return std::nullopt;
}

}  // namespace

Statistics summarize(const std::vector<Duration>& values) {
  Statistics s;
  s.count = values.size();
  if (values.empty()) return s;
  s.min = *std::min_element(values.begin(), values.end());
  s.max = *std::max_element(values.begin(), values.end());
  const auto count = static_cast<double>(values.size());
  for (const Duration value : values) s.mean_ns += static_cast<double>(value.ns()) / count;
  double variance = 0;
  for (const Duration value : values) variance += std::pow(static_cast<double>(value.ns()) - s.mean_ns, 2) / count;
  s.sd_ns = std::sqrt(variance);
  return s;
}

std::vector<Duration> stage_times(const RunRecord& record, DeviceId device, bool is_handle) {
  std::vector<Duration> times;
  for (const Interval& run : intervals(record, device, is_handle)) times.push_back(run.end - run.begin);
  return times;
}

std::optional<ChainPath> find_chain(const Robot& robot, DeviceId from, DeviceId to) {
  if (auto path = find_way(robot, from, to, false)) return path;
  return find_way(robot, from, to, true);
}

std::vector<DecisionSample> decision_samples(const RunRecord& record, const ChainPath& path) {
  std::vector<std::vector<Interval>> hops;  // from the actuator's handle back to the source's update
  for (auto device = path.down.rbegin(); device != path.down.rend(); ++device)
    hops.push_back(intervals(record, *device, true));
  for (auto device = path.up.rbegin(); device != path.up.rend(); ++device)
    hops.push_back(intervals(record, *device, false));

  std::vector<DecisionSample> samples;
  for (const Interval& last : hops.front()) {
    const Interval* run = &last;
    for (std::size_t hop = 1; hop < hops.size() && run != nullptr; ++hop) run = finished_by(hops[hop], run->begin);
    if (run != nullptr) samples.push_back({run->begin, last.end});
  }
  return samples;
}

}  // namespace finemote::gen
