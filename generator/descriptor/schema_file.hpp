// The JSON Schemas the tool ships, each as a text that stands alone.
#pragma once

#include <optional>
#include <string>

#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen {

/// The text of `file` in `folder`. Where it takes a definition from another schema there
/// (`device.schema.json#/definitions/params`), the definitions of that one are among its own; else it is unchanged.
/// Reports FM0007 for a file that is missing or no JSON.
std::optional<std::string> read_schema(const std::string& folder, const std::string& file, Diagnostics& diagnostics);

}  // namespace finemote::gen
