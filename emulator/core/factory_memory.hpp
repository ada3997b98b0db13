// What the maker writes into the system memory of a chip: who it is, how large its flash is, and how its converter
// measured itself. RM0090 39, DS8626 5.3.22, 5.3.24.
#pragma once

#include <cstdint>
#include <vector>

#include "emulator/core/memories.hpp"

namespace finemote::emulator {

/// The rest reads as erased.
inline std::vector<std::uint8_t> factory_memory() {
  std::vector<std::uint8_t> memory(Memories::kSystemBytes, 0xFF);
  const auto put = [&memory](std::uint32_t address, unsigned value) {
    memory[address - Memories::kSystemBase] = static_cast<std::uint8_t>(value);
    memory[address - Memories::kSystemBase + 1] = static_cast<std::uint8_t>(value >> 8);
  };
  constexpr std::uint32_t kIdentity = 0x1FFF7A10, kFlashKib = 0x1FFF7A22, kReference = 0x1FFF7A2A, kAt30 = 0x1FFF7A2C,
                          kAt110 = 0x1FFF7A2E;
  for (unsigned i = 0; i < 6; ++i) put(kIdentity + 2 * i, 0x3130 + 0x0202 * i);  // some lot, wafer and place on it
  put(kFlashKib, Memories::kFlashBytes / 1024);
  // Codes at 3.3 V: 1.21 V, and 0.76 V at 25 degrees Celsius with 2.5 mV more for each.
  put(kReference, 1501);
  put(kAt30, 958);
  put(kAt110, 1206);
  return memory;
}

}  // namespace finemote::emulator
