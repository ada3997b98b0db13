// Rules about one device: its place in the tree, its times and its params.
#pragma once

#include "generator/lint/rule.hpp"

namespace finemote::gen {

/// FM3151: children that handle later than they could; each can be moved. Handles run in the reverse order of
/// declaration: what is declared last is commanded first, so sensors belong before the actuators of their period.
void find_late_sensors(const CheckedDevice& checked, Findings& findings);
/// FM3152
void find_odd_period(const CheckedDevice& checked, Findings& findings);
/// FM3153
void find_missing_wcet(const CheckedDevice& checked, Findings& findings);
/// FM3154
void find_long_conversion(const CheckedDevice& checked, Findings& findings);
/// FM3157
void find_replaced_params(const CheckedDevice& checked, Findings& findings);
/// FM3161: a limit that data exceed in regular operation sends the device to its safe output time and again.
void find_old_commands(const CheckedDevice& checked, Findings& findings);

}  // namespace finemote::gen
