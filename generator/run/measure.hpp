// Events to runs of stages, and to the updates that the data of every command came from.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "generator/run/record.hpp"

namespace finemote::gen {

struct StageRun {
  Duration begin, end;
};

/// Completed runs of all stages, found in one pass over the events of a record.
class StageRuns {
 public:
  StageRuns(const RunRecord& record, std::size_t devices);

  /// In time order.
  [[nodiscard]] const std::vector<StageRun>& of(DeviceId device, bool is_handle) const {
    return runs_[device][is_handle ? 1 : 0];
  }

 private:
  Table<DeviceId, std::array<std::vector<StageRun>, 2>> runs_;
};

/// The run of a stage that ended then; null: none did.
const StageRun* ended_at(const std::vector<StageRun>& runs, Duration end);

/// Time from begin to end of every run of a stage that began after the bring-up, preemption included.
std::vector<Duration> stage_times(const RunRecord& record, const std::vector<StageRun>& runs);

/// How data from update() of one device reaches handle() of another. It turns at the root of the other's tree, as the
/// bound does: data that turns below is never older.
struct ChainFlow {
  DeviceId source;
  Table<DeviceId, std::vector<DeviceId>> feeders;  ///< of each device: whose updates with data of the source it reads
  std::vector<DeviceId> handles;                   ///< devices whose handle() it passes, the last first, the root last
};

/// The way along the tree where both are in one, else all ways over `reads` edges too. None when no data of `from`
/// reaches `to`.
std::optional<ChainFlow> find_chain(const Robot& robot, DeviceId from, DeviceId to);

/// One command of a chain's end, and the update its data came from.
struct DecisionSample {
  StageRun update;               ///< of the source
  Duration handle_end;           ///< of the actuator
  std::uint32_t handle_run = 0;  ///< which run of it since the first release, from 0
};

/// One sample per handle() of the chain's end: of the oldest data of all ways. Every hop takes the latest value
/// finished before the reader's stage began (paper, definition 3). Jobs at the start whose data comes from no update
/// yet, or from one during the bring-up, are left out.
std::vector<DecisionSample> decision_samples(const RunRecord& record, const StageRuns& runs,
                                             const std::optional<ChainFlow>& flow);

}  // namespace finemote::gen
