// Starts and carries on the releases; the interrupt itself is in the source file.
#pragma once

#include "finemote/schedule.hpp"

namespace finemote::cortex_m4 {

/// Programs the release timer and enables the buckets' lines; instant 0 is at most 100 ms later. `schedule` is
/// verified.
void start_releases(const Schedule& schedule);

/// In place of the release interrupt, once nothing is released any more: true when an instant has passed; keeps time
/// and watchdog going.
bool pass_instant();

}  // namespace finemote::cortex_m4
