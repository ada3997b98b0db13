// The trace ring behind an RTT control block, as debug probes find and read it while the robot runs.
#include "finemote/trace.hpp"

#ifdef FINEMOTE_TRACE

#include "runtime/chips/cortex_m4/core.hpp"
#include "runtime/chips/cortex_m4/trace.hpp"

namespace finemote {
namespace cortex_m4 {
namespace {

TraceEvent ring[kTraceEvents];

}  // namespace

}  // namespace cortex_m4
}  // namespace finemote

/// Found in RAM by its first 16 bytes. One buffer up, none down; a probe moves `read` only.
extern "C" {
extern finemote::cortex_m4::RttControl _SEGGER_RTT;
__attribute__((used)) finemote::cortex_m4::RttControl _SEGGER_RTT{
    "SEGGER RTT", 1, 0, {"finemote trace", finemote::cortex_m4::ring, sizeof finemote::cortex_m4::ring, 0, 0, 0}, 0};
}

namespace finemote {

// Masks interrupts for about twenty instructions.
void trace(std::uint32_t code) {
  const cortex_m4::Masked masked;
  auto& up = _SEGGER_RTT.up;
  const std::uint32_t write = up.write;
  const std::uint32_t after = write + sizeof(TraceEvent) == up.size ? 0 : write + sizeof(TraceEvent);
  if (after == up.read) {
    ++_SEGGER_RTT.lost;
  } else {
    up.buffer[write / sizeof(TraceEvent)] = {cortex_m4::cycles(), code};
    up.write = after;
  }
}

namespace cortex_m4 {

bool take_event(TraceEvent& event) {
  auto& up = _SEGGER_RTT.up;
  const std::uint32_t read = up.read;
  if (read == up.write) return false;
  event = up.buffer[read / sizeof(TraceEvent)];
  up.read = read + sizeof(TraceEvent) == up.size ? 0 : read + sizeof(TraceEvent);
  return true;
}

std::uint32_t lost_events() { return _SEGGER_RTT.lost; }

}  // namespace cortex_m4
}  // namespace finemote

#endif
