// What an analysis found to messages that say why, and what would help.
#pragma once

#include "generator/timing/analyse.hpp"

namespace finemote::gen::timing {

/// FM4016 for every requirement that fails: the largest part of it, who makes it, and the smallest `max` that holds.
void report_requirements(const Timing& timing, Diagnostics& diagnostics);

/// FM4021, a warning, for every bus that is asked for more than all of its time: by whom, and what makes room.
void report_bus_overloads(const Timing& timing, Diagnostics& diagnostics);

}  // namespace finemote::gen::timing
