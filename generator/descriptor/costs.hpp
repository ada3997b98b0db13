// What the runtime itself takes of the processor on a board: `costs` of a board file.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "generator/units/duration.hpp"

namespace finemote::gen {

/// Worst-case times; the board file says of each whether it is measured or assumed.
struct Costs {
  Duration release;             ///< release interrupt, without its buckets
  Duration release_per_bucket;  ///< for every released bucket
  /// Besides, where the releases of a hyperperiod do not fit the ring of the release timer: once, and for every bucket.
  Duration release_walk, release_walk_per_bucket;
  Duration exception_entry, exception_exit;
  Duration preemption;  ///< what an interrupted routine takes longer for each interrupt
  Duration bucket;      ///< entry, bookkeeping and completion of one job
  Duration stage;       ///< dispatch of one update or handle
  Duration masked_section;
  Duration flush, flush_per_channel;
  Duration flush_expander, flush_expander_per_channel;  ///< of a PWM expander: channels from the first to the last used
  Duration latch, latch_per_word;                       ///< publish or snapshot of a crossing; copy of four bytes
  Duration trace_event;
  std::optional<Duration> monitor_handle, monitor_job;  ///< none: the board does not say

  /// Throws Overflow.
  [[nodiscard]] Duration exception() const { return exception_entry + exception_exit + preemption; }
};

/// Reads a member that the schema accepts.
Costs read_costs(const nlohmann::ordered_json& value);

}  // namespace finemote::gen
