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
  Duration min, max;
  double mean_ns = 0, sd_ns = 0;  ///< fractions of a nanosecond count; sd: of the whole series (divides by count)
};

Statistics summarize(const std::vector<Duration>& values);

/// Time from begin to end of every completed run of a stage, preemption included.
std::vector<Duration> stage_times(const RunRecord& record, DeviceId device, bool is_handle);

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
  Duration update_begin;  ///< begin of the source's update()
  Duration handle_end;    ///< end of the actuator's handle()
};

/// One sample per handle() of the chain's end. Every hop takes the latest value finished before the reader's stage
/// began (paper, definition 3). Jobs at the start whose data comes from no update yet are left out.
std::vector<DecisionSample> decision_samples(const RunRecord& record, const ChainPath& path);

}  // namespace finemote::gen
