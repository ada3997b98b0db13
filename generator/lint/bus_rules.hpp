// Rules about buses: whether anything uses them, and how much of their time.
#pragma once

#include "generator/lint/rule.hpp"

namespace finemote::gen {

/// FM3156; the bus can be removed.
void find_unused_bus(const CheckedBus& checked, Findings& findings);
/// FM3155: busy for more of the time than it should be, and not overloaded.
void find_busy_bus(const CheckedBus& checked, Findings& findings);
/// FM4021, as the timing analysis found it.
void find_overloaded_bus(const CheckedBus& checked, Findings& findings);

}  // namespace finemote::gen
