// A saved document of `finemote run` to what a report shows of it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/timing/model.hpp"

namespace finemote::gen {

/// Reports what read_source() and json::parse() report, and FM0001 for a document that is no `finemote.run/1`, or is
/// one of another robot: it measures a device or chain that `model` lacks. Null then.
nlohmann::ordered_json read_run(const std::string& path, const timing::Model& model, Sources& sources,
                                Diagnostics& diagnostics);

}  // namespace finemote::gen
