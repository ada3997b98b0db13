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

  void begin_update(std::size_t device, timing::Ns now);
  void end_update(std::size_t device, timing::Ns now);
  void begin_handle(std::size_t device, timing::Ns now);
  /// Also raises the latency of every chain that ends at `device`.
  void end_handle(std::size_t device, timing::Ns now, std::vector<Simulation::ChainWorst>& chains);

  /// When the state or command of a device was published; for traces.
  [[nodiscard]] timing::Ns state_time(std::size_t device) const { return state_time_[device]; }
  [[nodiscard]] timing::Ns command_time(std::size_t device) const { return command_time_[device]; }

 private:
  static constexpr timing::Ns kNothing = -1;  ///< only initial values so far
  using Origins = std::vector<timing::Ns>;    ///< per source: start of the update the value goes back to

  const timing::Model& model_;
  std::vector<std::size_t> sources_;                       ///< devices
  std::vector<std::vector<std::size_t>> producers_;        ///< per device: children and observed devices
  std::vector<std::vector<char>> leads_;                   ///< per device and source: its state depends on it
  std::vector<Origins> seen_, state_, decided_, command_;  ///< per device: in the job; published; both directions
  std::vector<timing::Ns> state_time_, command_time_;
  std::vector<std::vector<std::pair<std::size_t, std::size_t>>> ends_;  ///< per device: (chain, source)
};

}  // namespace finemote::gen
