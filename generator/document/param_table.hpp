// The `params` of a descriptor or board file to a table of its reference page.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace finemote::gen {

/// `## Parameters` with a row for each of `params`; empty where `owner` has none.
std::string param_table(const nlohmann::ordered_json& owner);

}  // namespace finemote::gen
