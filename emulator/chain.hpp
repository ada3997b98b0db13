// Measures a chain on the stage events of a run: how old what `b` acted on was, from the update of `a` it came from.
#pragma once

#include <cstdint>
#include <vector>

#include "emulator/trace_reader.hpp"

namespace finemote::emulator {

/// A stage that ran: begin and end of one update or handle.
struct StageRun {
  std::int64_t begin_ns, end_ns;
};

/// All runs of every stage, in time order; index: stage number. Unfinished ones are left out.
std::vector<std::vector<StageRun>> stage_runs(const std::vector<StageEvent>& events);

/// One sample of a chain.
struct ChainSample {
  std::int64_t update_begin_ns;  ///< of `a`: where the data entered
  std::int64_t handle_end_ns;    ///< of `b`: where it left
};

/// Walks back from every handle() of `down.back()`: each device acted on what its parent's last finished handle() had
/// sent, the turning device on its own last update(), and each update() on what its child's last finished one had seen.
/// Start-up samples without a source are left out.
///
/// @param up    device indices from `a` to the device where the chain turns
/// @param down  device indices from that device to `b`
std::vector<ChainSample> chain_samples(const std::vector<std::vector<StageRun>>& runs, const std::vector<unsigned>& up,
                                       const std::vector<unsigned>& down);

}  // namespace finemote::emulator
