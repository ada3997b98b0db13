// Records the begin and end of every stage into a ring in RAM (build option FINEMOTE_TRACE).
#pragma once

#include <cstdint>

namespace finemote {

/// One event: 8 bytes in the ring, as a debug probe reads them.
struct TraceEvent {
  std::uint32_t cycles;  ///< low 32 bits of the core's cycle count since the first release
  std::uint32_t code;    ///< 2 * stage number + (0 begin, 1 end)
};

#ifdef FINEMOTE_TRACE
/// Appends one event stamped now; counts it as lost when the ring is full. From stages and interrupts alike.
void trace(std::uint32_t code);
#endif

}  // namespace finemote
