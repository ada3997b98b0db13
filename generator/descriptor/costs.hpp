// What the runtime itself takes of the processor on a board: `costs` of a board file.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace finemote::gen {

/// Worst-case times [ns]; the board file says of each whether it is measured or assumed.
struct Costs {
  std::int64_t release_ns = 0;             ///< release interrupt, without its buckets
  std::int64_t release_per_bucket_ns = 0;  ///< for every released bucket
  std::int64_t exception_entry_ns = 0, exception_exit_ns = 0;
  std::int64_t bucket_ns = 0;  ///< entry, bookkeeping and completion of one job
  std::int64_t stage_ns = 0;   ///< dispatch of one update or handle
  std::int64_t masked_section_ns = 0;
  std::int64_t flush_ns = 0, flush_per_channel_ns = 0;
  std::int64_t latch_ns = 0, latch_per_word_ns = 0;  ///< publish or snapshot of a crossing; copy of four bytes
  std::int64_t trace_event_ns = 0;
  std::optional<std::int64_t> monitor_handle_ns, monitor_job_ns;  ///< none: the board does not say

  [[nodiscard]] std::int64_t exception_ns() const { return exception_entry_ns + exception_exit_ns; }
};

/// Reads a member that the schema accepts.
Costs read_costs(const nlohmann::ordered_json& value);

}  // namespace finemote::gen
