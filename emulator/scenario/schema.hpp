// The table of a scenario to a JSON Schema, for editors and other tools.
#pragma once

#include <nlohmann/json.hpp>

namespace finemote::scenario {

/// schemas/scenario.schema.json. It knows no robot: names of parts are judged by the checker alone.
nlohmann::ordered_json json_schema();

}  // namespace finemote::scenario
