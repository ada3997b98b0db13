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

}  // namespace finemote::emulator
