// Which update of a chain's source every state and command goes back to, while a simulation runs.
#pragma once

#include <vector>

#include "generator/simulate/simulate.hpp"
#include "generator/timing/topology.hpp"

namespace finemote::gen {

/// Stages read published data at their start and publish at their end. A command is made at the root from what the
/// root's own update saw; on its way down every handle passes on what its parent published last.
class DataFlow {
 public:
  DataFlow(const timing::Model& model, const timing::Topology& topology, const std::vector<ChainEnds>& chains);

  void begin_update(Rank device, Duration now);
  void end_update(Rank device, Duration now);
  void begin_handle(Rank device, Duration now);
  /// Also raises the latency of every chain that ends at `device`.
  void end_handle(Rank device, Duration now, std::vector<Simulation::ChainWorst>& chains);

  /// When the state or command of a device was published; for traces.
  [[nodiscard]] Duration state_time(Rank device) const { return state_time_[device]; }
  [[nodiscard]] Duration command_time(Rank device) const { return command_time_[device]; }

 private:
  using Origins =
      std::vector<Duration>;  ///< per source: start of the update the value goes back to; kNothing: an initial value

  const timing::Model& model_;
  std::vector<Rank> sources_;                              ///< devices
  Table<Rank, std::vector<Rank>> producers_;               ///< children and observed devices
  Table<Rank, std::vector<char>> leads_;                   ///< per source: its state depends on it
  Table<Rank, Origins> seen_, state_, decided_, command_;  ///< in the job; published; both directions
  Table<Rank, Duration> state_time_, command_time_;
  Table<Rank, std::vector<std::pair<std::size_t, std::size_t>>> ends_;  ///< (chain, source)
};

}  // namespace finemote::gen
