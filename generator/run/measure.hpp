// Events to figures: how long stages took, and how old the data of every command was.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "generator/run/record.hpp"

namespace finemote::gen {

/// Smallest, mean, standard deviation and largest of a series, ns. With count 0 the rest means nothing.
struct Statistics {
  std::uint64_t count = 0;
  std::int64_t min_ns = 0, max_ns = 0;
  double mean_ns = 0, sd_ns = 0;  ///< sd: of the whole series (divides by count)
};

Statistics summarize(const std::vector<std::int64_t>& values);

/// Time from begin to end of every completed run of a stage, preemption included.
std::vector<std::int64_t> stage_times(const RunRecord& record, DeviceId device, bool is_handle);

/// The way of data from update() of one device to handle() of another.
struct ChainPath {
  std::vector<DeviceId> up;    ///< devices whose update() it passes, source first; the last one turns
  std::vector<DeviceId> down;  ///< devices whose handle() it passes, the turning one first, the actuator last
  bool through_reads = false;  ///< uses a `reads` edge: outside the paper's Theorem 3
};

/// The way with the lowest turning point: over tree edges where there is one, else also over `reads` edges.
/// None when no data of `from` reaches `to`.
std::optional<ChainPath> find_chain(const Robot& robot, DeviceId from, DeviceId to);

/// One command of a chain's end, and the update its data came from.
struct DecisionSample {
  std::int64_t update_begin_ns = 0;  ///< begin of the source's update()
  std::int64_t handle_end_ns = 0;    ///< end of the actuator's handle()
};

/// One sample per handle() of the chain's end. Every hop takes the latest value finished before the reader's stage
/// began (paper, definition 3). Jobs at the start whose data comes from no update yet are left out.
std::vector<DecisionSample> decision_samples(const RunRecord& record, const ChainPath& path);

}  // namespace finemote::gen
