// Checks a JSON value with one of the JSON Schemas the tool ships, and points at what it refuses.
#pragma once

#include <string>
#include <vector>

#include "generator/descriptor/json_file.hpp"

namespace finemote::gen {

/// What the schema refuses, for whoever reads on.
struct SchemaMistake {
  JsonPath path;
  bool is_unknown = false;  ///< the path ends in a member that should not be there
  std::string meant;        ///< the one name or value that is near; empty: none, or several
};

/// Checks `value`, which `origin` says, with the JSON Schema
/// text `schema`. Reports FM3102 for every violation that has no more precise one below it, and FM0007 for a text that
/// is no schema.
/// @return  the violations; empty for a valid value.
std::vector<SchemaMistake> check_schema(const Json& value, const std::string& schema, const Origin& origin,
                                        Diagnostics& diagnostics);

}  // namespace finemote::gen
