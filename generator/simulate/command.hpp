// `finemote simulate`, from a model on.
#pragma once

#include <iosfwd>

#include "generator/simulate/simulate.hpp"
#include "generator/timing/analyse.hpp"

namespace finemote::gen {

struct SimulateOptions {
  std::uint64_t seed = 1;
  timing::Ns duration_ns = 10'000'000'000;
  std::vector<std::string> chains;         ///< `a->b`, beyond the default ones
  std::optional<timing::Profile> profile;  ///< none: target where the model has one, else tight
  bool json = false;
  std::ostream* trace = nullptr;  ///< Chrome trace; null: none
};

/// Simulates and writes the table or `finemote.simulation/1` to `out`: worst observed values beside their bounds.
/// Returns the exit status: 0, 1 (a release was missed, or something observed is above its bound), 2 (no answer).
int run_simulate(const timing::Model& model, const SimulateOptions& options, Diagnostics& diagnostics,
                 std::ostream& out);

}  // namespace finemote::gen
