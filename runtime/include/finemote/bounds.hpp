// What the timing analysis proves of a device, as the generated schedule.hpp states it.
#pragma once

#include <cstdint>

#include "finemote/time.hpp"

namespace finemote {

/// Stands where nothing is proven, or where there is nothing to bound.
inline constexpr Duration kUnbounded = INT64_MAX;

/// Of one device, without the options FINEMOTE_TRACE and FINEMOTE_MONITOR.
struct Bounds {
  Duration response;  ///< release to end of handle()
  Duration age;       ///< of the oldest data behind its command, when handle() ends
  Duration output;    ///< of the same data, when the last bit of the command is out
};

}  // namespace finemote
