// Turns a Thumb instruction into what it costs and what the emulator must look at after it.
#pragma once

#include <cstdint>

namespace finemote::emulator {

/// What is known of an instruction without running it. One byte each: there is a table of them for the whole flash.
struct InstructionInfo {
  static constexpr std::uint8_t kFloatingPoint = 1;  ///< needs the FPU, makes its context active
  static constexpr std::uint8_t kMovesStack = 2;     ///< may move the stack pointer down
  static constexpr std::uint8_t kJumps = 4;          ///< may go on elsewhere
  static constexpr std::uint8_t kLoadsPc = 8;        ///< LDR to the PC
  static constexpr std::uint8_t kAlone = 16;         ///< the next one is not simply the one after it in the image

  std::uint8_t cycles = 0;
  std::uint8_t flags = 0;
  std::uint8_t bytes = 0;  ///< 2 or 4
};

/// @param first, second  the halfwords at the instruction; second is ignored for a 16-bit one
/// Cycles: Cortex-M4 TRM (DDI 0439) tables 3-1 and 7-1, memory without wait states, branch penalty and interlocks not
/// included; where the tables give a range (divisions, CPS, MRS), its end.
InstructionInfo decode(std::uint16_t first, std::uint16_t second);

/// Cycles to refill the pipeline after a jump: the TRM says 1 to 3, by alignment and what was fetched ahead.
inline constexpr unsigned kRefillCycles = 3;

}  // namespace finemote::emulator
