// A simulated run beside its bounds to JSON: `finemote.simulation/1`.
#pragma once

#include "generator/simulate/beside_bounds.hpp"
#include "generator/timing/json.hpp"

namespace finemote::gen {

/// The whole document, without `diagnostics`.
timing::Json simulation_json(const timing::Timing& timing, const Simulation& run, const SimulationRequest& request);

}  // namespace finemote::gen
