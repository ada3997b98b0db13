// Rules about what the type of a device says of it.
#pragma once

#include "generator/lint/rule.hpp"

namespace finemote::gen {

/// FM3170: an actuator that takes no commands, or a device on a bus that takes some and is never made safe.
void find_half_actuators(const CheckedDevice& checked, Findings& findings);

}  // namespace finemote::gen
