// Words of the machine as people read them in reports.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

namespace finemote::emulator {

/// All eight digits: `0x0800010C`.
inline std::string hex(std::uint32_t value) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%08X", value);
  return text;
}

}  // namespace finemote::emulator
