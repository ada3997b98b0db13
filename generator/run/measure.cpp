#include "generator/run/measure.hpp"

#include <algorithm>

namespace finemote::gen {
namespace {

/// The last run that was finished at `time`.
const StageRun* finished_by(const std::vector<StageRun>& runs, Duration time) {
  const auto after =
      std::upper_bound(runs.begin(), runs.end(), time, [](Duration t, const StageRun& run) { return t < run.end; });
  return after == runs.begin() ? nullptr : &*std::prev(after);
}

/// From a device to the root of its tree.
std::vector<DeviceId> way_to_root(const Robot& robot, DeviceId from) {
  std::vector<DeviceId> way{from};
  while (const auto parent = robot.devices[way.back()].parent) way.push_back(*parent);
  return way;
}

/// Ways over parents and readers, depth first. Robots are read only when neither goes in a circle.
class WaysUp {
 public:
  WaysUp(const Robot& robot, DeviceId to) : to_(to), next_(robot.devices.size()) {
    for (const DeviceId reader : robot.devices.ids()) {
      for (const Read& read : robot.devices[reader].reads) next_[read.device].push_back(reader);
      if (robot.devices[reader].parent) next_[reader].push_back(*robot.devices[reader].parent);
    }
  }

  std::vector<std::vector<DeviceId>> from(DeviceId device) {
    way_.push_back(device);
    if (device == to_) ways_.push_back(way_);
    for (const DeviceId next : next_[device]) {
      const bool is_passed = std::find(way_.begin(), way_.end(), next) != way_.end();
      if (!is_passed && ways_.size() < kMostWays) from(next);
    }
    way_.pop_back();
    return ways_;
  }

 private:
  static constexpr std::size_t kMostWays = 64;
  DeviceId to_;
  Table<DeviceId, std::vector<DeviceId>> next_;
  std::vector<DeviceId> way_;
  std::vector<std::vector<DeviceId>> ways_;
};

}  // namespace

StageRuns::StageRuns(const RunRecord& record, std::size_t devices) : runs_(devices) {
  Table<DeviceId, std::array<std::optional<Duration>, 2>> begins(devices);  // none: it does not run
  for (const Event& event : record.events) {
    const std::size_t stage = event.is_handle ? 1 : 0;
    std::optional<Duration>& begin = begins[event.device][stage];
    if (event.is_end && begin) runs_[event.device][stage].push_back({*begin, event.at});
    begin = event.is_end ? std::nullopt : std::optional(event.at);
  }
}

const StageRun* ended_at(const std::vector<StageRun>& runs, Duration end) {
  const StageRun* run = finished_by(runs, end);
  return run != nullptr && run->end == end ? run : nullptr;
}

std::vector<Duration> stage_times(const RunRecord& record, const std::vector<StageRun>& runs) {
  std::vector<Duration> times;
  for (const StageRun& run : runs) {
    if (run.begin >= record.ready) times.push_back(record.true_time(run.end - run.begin));
  }
  return times;
}

std::vector<ChainPath> find_chain(const Robot& robot, DeviceId from, DeviceId to) {
  std::vector<DeviceId> down = way_to_root(robot, to);
  std::reverse(down.begin(), down.end());
  const std::vector<DeviceId> up = way_to_root(robot, from);
  if (up.back() == down.front()) return {{up, down}};
  std::vector<ChainPath> all;
  for (const std::vector<DeviceId>& way : WaysUp(robot, down.front()).from(from)) all.push_back({way, down});
  return all;
}

namespace {

using Hops = std::vector<const std::vector<StageRun>*>;

/// The runs of every stage on the way, from the actuator's handle back to the source's update.
Hops hops_of(const StageRuns& runs, const ChainPath& path) {
  Hops hops;
  for (auto device = path.down.rbegin(); device != path.down.rend(); ++device) hops.push_back(&runs.of(*device, true));
  for (auto device = path.up.rbegin(); device != path.up.rend(); ++device) hops.push_back(&runs.of(*device, false));
  return hops;
}

/// The update that the data of the chain's last run came from; null: none yet.
const StageRun* source_of(const Hops& hops, const StageRun& last) {
  const StageRun* run = &last;
  for (std::size_t hop = 1; hop < hops.size() && run != nullptr; ++hop) run = finished_by(*hops[hop], run->begin);
  return run;
}

}  // namespace

std::vector<DecisionSample> decision_samples(const RunRecord& record, const StageRuns& runs,
                                             const std::vector<ChainPath>& paths) {
  std::vector<Hops> ways;
  for (const ChainPath& path : paths) ways.push_back(hops_of(runs, path));
  std::vector<DecisionSample> samples;
  if (ways.empty()) return samples;
  const std::vector<StageRun>& handles = *ways.front().front();
  for (std::size_t run = 0; run < handles.size(); ++run) {
    const StageRun* oldest = nullptr;
    bool came_by_all = true;
    for (const Hops& way : ways) {
      const StageRun* source = source_of(way, handles[run]);
      came_by_all = came_by_all && source != nullptr;
      if (source != nullptr && (oldest == nullptr || source->begin < oldest->begin)) oldest = source;
    }
    if (came_by_all && oldest->begin >= record.ready)
      samples.push_back({*oldest, handles[run].end, static_cast<std::uint32_t>(run)});
  }
  return samples;
}

}  // namespace finemote::gen
