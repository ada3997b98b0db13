// A device type to the made part of its reference page.
#pragma once

#include <string>

#include "generator/descriptor/device_type.hpp"

namespace finemote::gen {

/// Summary, facts and parameters, as Markdown.
std::string device_page(const DeviceType& type);

}  // namespace finemote::gen
