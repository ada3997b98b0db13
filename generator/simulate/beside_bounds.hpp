// A model to the worst a simulated run has shown, beside the bounds it must not exceed.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "generator/simulate/simulate.hpp"
#include "generator/timing/analyse.hpp"

namespace finemote::gen {

struct SimulationRequest {
  std::uint64_t seed = 1;
  Duration duration = seconds(10);
  std::vector<std::string> chains = {};                   ///< `a->b`, beyond the default ones
  std::optional<timing::Profile> profile = std::nullopt;  ///< none: target where the model has one, else tight
  std::vector<timing::Requirement> requirements = {};     ///< whose chains are simulated, too; nothing else of them
};

/// A run and the analysis of its model; `run.chains` are those of `timing`, in the same order.
struct SimulatedModel {
  timing::Timing timing;
  Simulation run;

  /// Nothing that was observed is above its bound.
  [[nodiscard]] bool holds() const;
  /// It holds, every release was served, and the analysis promises as much.
  [[nodiscard]] bool good() const { return timing.schedulable && run.misses == 0 && holds(); }
};

/// What is simulated beside the bounds of `timing`: all its chains. Profile paper is simulated as tight: its buses
/// interrupt more often than any wire can.
SimulationOptions options_beside(const timing::Timing& timing, const SimulationRequest& request);

/// An observed value; none where nothing was.
std::optional<Duration> observed(Duration worst);

/// Analyses and simulates.
/// @param trace  where a Chrome trace is written; null: none
/// @return  none where timing::parse_chains or timing::analyse report an error and give no answer, and where a time of
/// the run leaves 64 bits, which is reported as FM4010
std::optional<SimulatedModel> simulate_beside_bounds(const timing::Model& model, const SimulationRequest& request,
                                                     Diagnostics& diagnostics, std::ostream* trace = nullptr);

}  // namespace finemote::gen
