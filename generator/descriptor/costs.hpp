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
  Duration exception_entry, exception_exit;
  Duration bucket;  ///< entry, bookkeeping and completion of one job
  Duration stage;   ///< dispatch of one update or handle
  Duration masked_section;
  Duration flush, flush_per_channel;
  Duration latch, latch_per_word;  ///< publish or snapshot of a crossing; copy of four bytes
  Duration trace_event;
  std::optional<Duration> monitor_handle, monitor_job;  ///< none: the board does not say

  [[nodiscard]] Duration exception() const { return exception_entry + exception_exit; }  ///< throws Overflow
};

/// Reads a member that the schema accepts.
Costs read_costs(const nlohmann::ordered_json& value);

}  // namespace finemote::gen
