// What no JSON Schema can see in a device descriptor: members that contradict each other.
#pragma once

#include "generator/descriptor/device_type.hpp"
#include "generator/descriptor/json_file.hpp"

namespace finemote::gen {

/// Reports FM3103, at the member of the text the type was read from: a role or use twice, max below min, geometry of a
/// role that does not exist, a WCET param that does not exist.
void check_device_type(const DeviceType& type, const Origin& origin, Diagnostics& diagnostics);

}  // namespace finemote::gen
