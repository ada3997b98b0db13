// The stages of a run for a viewer of traces.
#pragma once

#include <nlohmann/json.hpp>

#include "generator/run/run_result.hpp"

namespace finemote::gen {

/// Chrome trace for Perfetto: one track per bucket, a slice for every uninterrupted piece of a stage.
nlohmann::ordered_json run_trace(const RunResult& result);

}  // namespace finemote::gen
