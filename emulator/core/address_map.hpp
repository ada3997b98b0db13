// What stands where in the address space, memories apart.
#pragma once

#include <cstdint>

namespace finemote::emulator {

inline bool lies_in(std::uint32_t address, std::uint32_t base, std::uint32_t bytes) { return address - base < bytes; }

/// RM0090 2.3: APB1, APB2 and AHB1; AHB2; the registers of the memory controller.
inline bool is_peripheral(std::uint32_t address) {
  return lies_in(address, 0x40000000, 0x80000) || lies_in(address, 0x50000000, 0x61000) ||
         lies_in(address, 0xA0000000, 0x1000);
}

/// The private peripheral bus: trace, data watchpoints, the system control space, and the debug unit. PM0214 2.2.
inline bool is_system(std::uint32_t address) { return lies_in(address, 0xE0000000, 0x100000); }

}  // namespace finemote::emulator
