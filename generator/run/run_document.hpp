// The result of a run as a document.
#pragma once

#include <nlohmann/json.hpp>

#include "generator/run/run_result.hpp"

namespace finemote::gen {

/// `finemote.run/1` without diagnostics.
nlohmann::ordered_json run_document(const RunResult& result);

}  // namespace finemote::gen
