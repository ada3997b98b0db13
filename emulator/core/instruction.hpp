// Turns a Thumb instruction into what it costs and what the emulator must look at after it.
#pragma once

#include <cstdint>

namespace finemote::emulator {

/// What is known of an instruction without running it. One byte each: there is a table of them for the whole flash.
struct InstructionInfo {
  static constexpr std::uint8_t kFloatingPoint = 1;  ///< needs the FPU, makes its context active
  static constexpr std::uint8_t kMasks = 2;          ///< may change which interrupts are let through
  static constexpr std::uint8_t kWaits = 4;          ///< WFI
  static constexpr std::uint8_t kMovesStack = 8;     ///< may move the stack pointer down
  static constexpr std::uint8_t kIfThen = 16;        ///< IT: the next 1..4 instructions are conditional
  static constexpr std::uint8_t kBarrier = 32;       ///< DSB, ISB, DMB
  static constexpr std::uint8_t kLoadsPc = 64;       ///< LDR to the PC

  std::uint8_t cycles = 0;  ///< 0: not decoded yet
  std::uint8_t flags = 0;
  std::uint8_t bytes = 0;  ///< 2 or 4
};

/// @param first, second  the halfwords at the instruction; second is ignored for a 16-bit one
/// Cycles: Cortex-M4 TRM (DDI 0439) tables 3-1 and 7-1, memory without wait states, branch penalty not included; a
/// division takes its maximum.
InstructionInfo decode(std::uint16_t first, std::uint16_t second);

/// Cycles to refill the pipeline after a jump: the TRM says 1 to 3.
inline constexpr unsigned kRefillCycles = 2;

}  // namespace finemote::emulator
