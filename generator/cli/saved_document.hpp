// Documents that commands printed with --format json, read again for a report.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/timing/model.hpp"

namespace finemote::gen {

/// What `finemote run` printed. Reports what read_source() and json::parse() report, and FM0001 for a document that is
/// no `finemote.run/1`, or is one of another robot: it measures a device or chain that `model` lacks. Null then.
nlohmann::ordered_json read_run(const std::string& path, const timing::Model& model, Sources& sources,
                                Diagnostics& diagnostics);

/// What `finemote analyze` printed; the same of `finemote.timing/1`, of any robot.
nlohmann::ordered_json read_timing(const std::string& path, Sources& sources, Diagnostics& diagnostics);

}  // namespace finemote::gen
