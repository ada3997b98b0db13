// The serial line of a part, out of its entry.
#pragma once

#include "emulator/chip/usart.hpp"
#include "emulator/outfit/entry.hpp"

namespace finemote::emulator {

inline SerialFormat format_of(const Json& part) {
  SerialFormat format;
  format.baud = need<std::uint32_t>(part, "baud");
  format.even_parity = maybe(part, "even_parity", false);
  format.stop_bits = need<unsigned>(part, "stop_bits");
  return format;
}

inline Time period_of(const Json& part) { return from_ns(need<std::uint64_t>(part, "period_ns")); }
inline Time phase_of(const Json& part) { return from_ns(maybe<std::uint64_t>(part, "phase_ns", 0)); }

}  // namespace finemote::emulator
