// Timing results to JSON, in the shapes of the analysis cases and of `finemote.timing/1`.
#pragma once

#include <nlohmann/json.hpp>

#include "generator/timing/analyse.hpp"

namespace finemote::gen::timing {

using Json = nlohmann::ordered_json;

/// The model as read_model reads it; members of profile `target` only where they differ from their default.
Json model_json(const Model& model);

/// `utilization`, `liu_layland`, `hyperbolic_ok` and `buses`, added to `out`.
void add_utilization(const Model& model, const UtilizationTests& tests, Json& out);

/// The whole document `finemote.timing/1`, without `diagnostics`.
Json timing_json(const Timing& timing);

/// One profile: `schedulable`, `buckets`, `devices`, `trees`.
Json profile_json(const Model& model, const ProfileResult& result);

}  // namespace finemote::gen::timing
