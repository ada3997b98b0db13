// The memories of the STM32F407, by address: RM0090 2.3.1.
#pragma once

#include <cstdint>

namespace finemote::emulator {

/// They outlive those who use them.
struct Memories {
  static constexpr std::uint32_t kFlashBase = 0x08000000, kFlashBytes = 0x100000;  ///< also at 0 after a reset
  static constexpr std::uint32_t kRamBase = 0x20000000, kRamBytes = 0x20000;
  static constexpr std::uint32_t kMainRamBytes = 0x1C000;  ///< of it SRAM1, which can stand at 0: RM0090 9.2.1
  static constexpr std::uint32_t kCoreRamBase = 0x10000000, kCoreRamBytes = 0x10000;  ///< not executable
  static constexpr std::uint32_t kSystemBase = 0x1FFF7000, kSystemBytes = 0x1000;     ///< read only

  std::uint8_t *flash, *ram, *core_ram, *system;
};

}  // namespace finemote::emulator
