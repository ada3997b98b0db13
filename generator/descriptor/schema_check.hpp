// Checks a JSON value with one of the JSON Schemas the tool ships, and points at what it refuses.
#pragma once

#include <string>

#include "generator/descriptor/json_file.hpp"

namespace finemote::gen {

/// Checks `value`, which was read from `source` (or made by merging it over another board), with the JSON Schema
/// text `schema`. Reports FM3102 for every violation that has no more precise one below it.
/// @return whether the value is valid.
bool check_schema(const Json& value, const std::string& schema, const SourceFile& source, Diagnostics& diagnostics);

}  // namespace finemote::gen
