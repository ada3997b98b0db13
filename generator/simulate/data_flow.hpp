// Which update of a chain's source every state and command goes back to, while a simulation runs.
#pragma once

#include <algorithm>
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
  /// How many values a stage of the device reads at most.
  [[nodiscard]] std::size_t width(Rank device) const {
    return std::max(inputs_[device].size(), decided_[device].size());
  }

 private:
  /// Per source that leads to a device, in the order of sources: start of the update the value goes back to; kNothing:
  /// an initial value.
  using Origins = std::vector<Duration>;
  /// A value that an update reads: of which producer, the place there, and the place at the reader.
  struct Input {
    Rank producer;
    std::size_t from, to;
  };
  /// A chain, and the place of its source at the root.
  struct End {
    std::size_t chain, source;
  };

  void find_leads(const timing::Topology& topology, const std::vector<ChainEnds>& chains);
  [[nodiscard]] std::size_t place(Rank device, Rank source) const;

  const timing::Model& model_;
  Table<Rank, std::vector<Rank>> leads_;    ///< the sources a device's state depends on, ascending
  Table<Rank, std::vector<Input>> inputs_;  ///< from children and observed devices
  Table<Rank, Origins> seen_, state_;       ///< in the job; published
  Table<Rank, Origins> decided_, command_;  ///< the same for what the root made of its sources
  Table<Rank, Duration> state_time_, command_time_;
  Table<Rank, std::vector<End>> ends_;
};

}  // namespace finemote::gen
