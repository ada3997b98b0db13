// What an analysis found to messages that say why, and what would help.
#pragma once

#include "generator/timing/remedy.hpp"

namespace finemote::gen::timing {

/// FM4027 where releases of the asked profile can be lost and nothing else is wrong with it; returns whether it is so.
bool report_release(const Timing& timing, Diagnostics& diagnostics);

/// FM4015 for every bucket of the asked profile that may run over its period. The first one says who uses the
/// processor, largest load first.
void report_buckets(const Timing& timing, Trials& trials, Diagnostics& diagnostics);

/// FM4016 for every requirement that fails: the largest part of it, who makes it, and the smallest `max` that holds.
void report_requirements(const Timing& timing, Trials& trials, Diagnostics& diagnostics);

/// FM4021, a warning, for every overloaded bus: who uses it, and what makes room.
void report_bus_overloads(const Timing& timing, Trials& trials, Diagnostics& diagnostics);

}  // namespace finemote::gen::timing
