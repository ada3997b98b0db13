// What the runtime itself takes of the processor on a board: `costs` of a board file.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "generator/units/duration.hpp"

namespace finemote::gen {

/// Where a board runs its code, which some costs depend on.
enum class CodePlace { flash, sram };

/// Worst-case times; the board file says of each whether it is measured or assumed.
struct Costs {
  Duration release;             ///< release interrupt, without its buckets
  Duration release_per_bucket;  ///< for every released bucket
  /// Besides, where the releases of a hyperperiod do not fit the ring of the release timer: once, and for every bucket.
  Duration release_walk, release_walk_per_bucket;
  Duration exception_entry, exception_exit;  ///< of a routine that leaves the FPU alone
  Duration fpu_context;                      ///< besides, of one that does not: its registers are saved and restored
  Duration preemption;                       ///< what an interrupted routine takes longer for each interrupt
  Duration bucket;                           ///< entry, bookkeeping and completion of one job
  Duration stage;                            ///< dispatch of one update or handle
  Duration masked_section;
  Duration flush, flush_per_channel;
  Duration flush_expander, flush_expander_per_channel;  ///< of a PWM expander: channels from the first to the last used
  Duration latch, latch_per_word;                       ///< publish or snapshot of a crossing; copy of four bytes
  Duration trace_event;
  std::optional<Duration> event_entry, event_pause;     ///< what the ports date events by; none: the board does not say
  std::optional<Duration> monitor_handle, monitor_job;  ///< none: the board does not say

  /// Of an interrupt of the release or of a bus. Throws Overflow.
  [[nodiscard]] Duration interrupt() const { return exception_entry + exception_exit + preemption; }
  /// Of the interrupt that a job runs in. Throws Overflow.
  [[nodiscard]] Duration job() const { return interrupt() + fpu_context; }
};

/// Reads a member that the schema accepts.
Costs read_costs(const nlohmann::ordered_json& value, CodePlace place);

}  // namespace finemote::gen
