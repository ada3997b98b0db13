// A device type's descriptor to the made part of its reference page.
#pragma once

#include <string>

namespace finemote::gen {

/// Summary, facts and parameters, as Markdown. `descriptor` is the text of the JSON file, `include` what generated code
/// includes for it.
std::string device_page(const std::string& descriptor, const std::string& include);

}  // namespace finemote::gen
