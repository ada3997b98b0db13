// The layout of the trace ring in RAM, and reading it from inside the image.
#pragma once

#include <cstdint>

#include "finemote/trace.hpp"

#ifndef FINEMOTE_TRACE_EVENTS
#define FINEMOTE_TRACE_EVENTS 512
#endif

namespace finemote::cortex_m4 {

/// Events the ring holds, less one; 8 bytes each.
inline constexpr std::uint32_t kTraceEvents = FINEMOTE_TRACE_EVENTS;

/// RTT's control block: identifier, counts, then one descriptor per buffer (here one). Offsets count bytes.
struct RttControl {
  char id[16];
  std::int32_t up_buffers;
  std::int32_t down_buffers;
  struct {
    const char* name;
    TraceEvent* buffer;
    std::uint32_t size;
    volatile std::uint32_t write;
    volatile std::uint32_t read;
    std::uint32_t flags;  ///< 0: the writer skips what does not fit
  } up;
  std::uint32_t lost;  ///< ours: events that did not fit
};

/// Takes the oldest event out of the ring; one reader only.
bool take_event(TraceEvent& event);
std::uint32_t lost_events();

}  // namespace finemote::cortex_m4
