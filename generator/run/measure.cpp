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

/// Those whose update() a device's update() reads.
Table<DeviceId, std::vector<DeviceId>> feeders_of_all(const Robot& robot) {
  Table<DeviceId, std::vector<DeviceId>> feeders(robot.devices.size());
  for (const DeviceId reader : robot.devices.ids()) {
    for (const Read& read : robot.devices[reader].reads) feeders[reader].push_back(read.device);
    if (const auto parent = robot.devices[reader].parent) feeders[*parent].push_back(reader);
  }
  return feeders;
}

/// Leaves out of `feeders` what no data of `source` passes. True where they reach `device`.
class Reach {
 public:
  Reach(DeviceId source, Table<DeviceId, std::vector<DeviceId>>& feeders)
      : source_(source), feeders_(feeders), reached_(feeders.size()) {}

  bool reaches(DeviceId device) {  // robots are read only when neither parents nor readers go in a circle
    if (device == source_) return true;
    if (!reached_[device]) {
      std::erase_if(feeders_[device], [&](DeviceId feeder) { return !reaches(feeder); });
      reached_[device] = !feeders_[device].empty();
    }
    return *reached_[device];
  }

 private:
  DeviceId source_;
  Table<DeviceId, std::vector<DeviceId>>& feeders_;
  Table<DeviceId, std::optional<bool>> reached_;
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

std::optional<ChainFlow> find_chain(const Robot& robot, DeviceId from, DeviceId to) {
  ChainFlow flow{from, Table<DeviceId, std::vector<DeviceId>>(robot.devices.size()), way_to_root(robot, to)};
  const DeviceId root = flow.handles.back();
  const std::vector<DeviceId> up = way_to_root(robot, from);
  if (up.back() == root) {
    for (std::size_t i = 1; i < up.size(); ++i) flow.feeders[up[i]] = {up[i - 1]};
    return flow;
  }
  flow.feeders = feeders_of_all(robot);
  return Reach(from, flow.feeders).reaches(root) ? std::optional(std::move(flow)) : std::nullopt;
}

namespace {

/// From the runs of the stages of a chain to the updates of its source.
class Origins {
 public:
  Origins(const StageRuns& runs, const ChainFlow& flow) : runs_(runs), flow_(flow), known_(flow.feeders.size()) {}

  /// The oldest update of the source that data of a command of its end came from; null: of some feeder none yet.
  const StageRun* of_command(const StageRun& handle) {
    const StageRun* run = &handle;
    for (std::size_t hop = 1; hop < flow_.handles.size() && run != nullptr; ++hop)
      run = finished_by(runs_.of(flow_.handles[hop], true), run->begin);
    return run != nullptr ? of_latest_update(flow_.handles.back(), run->begin) : nullptr;
  }

 private:
  const StageRun* of_latest_update(DeviceId device, Duration time) {
    const std::vector<StageRun>& updates = runs_.of(device, false);
    const StageRun* run = finished_by(updates, time);
    if (run == nullptr || device == flow_.source) return run;
    auto& known = known_[device];
    known.resize(updates.size());
    auto& origin = known[static_cast<std::size_t>(run - updates.data())];
    if (!origin) origin = oldest_of_feeders(device, run->begin);
    return *origin;
  }

  const StageRun* oldest_of_feeders(DeviceId device, Duration time) {
    const StageRun* oldest = nullptr;
    for (const DeviceId feeder : flow_.feeders[device]) {
      const StageRun* origin = of_latest_update(feeder, time);
      if (origin == nullptr) return nullptr;
      if (oldest == nullptr || origin->begin < oldest->begin) oldest = origin;
    }
    return oldest;
  }

  const StageRuns& runs_;
  const ChainFlow& flow_;
  Table<DeviceId, std::vector<std::optional<const StageRun*>>> known_;
};

}  // namespace

std::vector<DecisionSample> decision_samples(const RunRecord& record, const StageRuns& runs,
                                             const std::optional<ChainFlow>& flow) {
  std::vector<DecisionSample> samples;
  if (!flow) return samples;
  Origins origins(runs, *flow);
  const std::vector<StageRun>& handles = runs.of(flow->handles.front(), true);
  for (std::size_t run = 0; run < handles.size(); ++run) {
    const StageRun* update = origins.of_command(handles[run]);
    if (update != nullptr && update->begin >= record.ready)
      samples.push_back({*update, handles[run].end, static_cast<std::uint32_t>(run)});
  }
  return samples;
}

}  // namespace finemote::gen
