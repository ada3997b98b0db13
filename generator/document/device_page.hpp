// A device type's descriptor to the made part of its reference page.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace finemote::gen {

/// Summary, facts and parameters, as Markdown. `include` is what generated code includes for it.
std::string device_page(const nlohmann::ordered_json& descriptor, const std::string& include);

}  // namespace finemote::gen
