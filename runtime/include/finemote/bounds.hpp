// What the timing analysis proves of a device, as the generated schedule.hpp states it.
#pragma once

#include <cstdint>

#include "finemote/time.hpp"

namespace finemote {

/// No bound is proven: the bucket may be overloaded, or the analysis gives no answer.
inline constexpr Duration kUnproven = INT64_MAX;

/// There is nothing to bound: a device that takes no command from another one has no age of it. As a limit it is never
/// exceeded, like kUnproven.
inline constexpr Duration kNothingToBound = INT64_MAX - 1;

/// Of one device, without the options FINEMOTE_TRACE and FINEMOTE_MONITOR.
struct Bounds {
  Duration response;  ///< release to end of handle() [ns], or kUnproven
  Duration age;       ///< of the oldest data behind its command, when handle() ends [ns], kUnproven or kNothingToBound;
                      ///< the true one: by their `origin` they may look older
  Duration output;    ///< of the same data, when the last bit of the command is out [ns]; the same
};

}  // namespace finemote
