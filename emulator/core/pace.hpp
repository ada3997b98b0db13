// How instructions become time: counts them, charges their cycles, jumps and flash fetches.
#pragma once

#include <cstdint>

#include "emulator/core/cost.hpp"
#include "emulator/core/instruction.hpp"
#include "emulator/core/memories.hpp"
#include "emulator/time.hpp"

namespace finemote::emulator {

struct Pace {
  static constexpr std::uint32_t kNoLine = 0xFFFFFFFFU;
  static constexpr Time kQemuInstruction = from_ns(8);

  CostModel cost = CostModel::cortex_m4;
  FlashModel flash = FlashModel::hit;
  unsigned flash_wait = 5;  ///< wait states of a miss; those of 168 MHz: RM0090 3.5.1, table 10
  Time time = 0;
  Time cycle = 0;                          ///< of the core clock
  Time stop_at = 0;                        ///< the interpreter asks before the first instruction at or after this time
  std::uint32_t expected = 0;              ///< where the next instruction is without a jump
  std::uint32_t line = 0;                  ///< of flash or RAM, fetched last
  bool ram_at_zero = false;                ///< and not the flash
  std::uint32_t it_begin = 0, it_end = 0;  ///< the IT instruction seen last, and the end of its block
  std::uint64_t instructions = 0;
  std::uint64_t waits = 0;  ///< of them, iterations of jumps to themselves that were charged without being run
  Time waited = 0;          ///< what those took

  void charge(unsigned cycles) {
    if (cost != CostModel::qemu) time += cycles * cycle;
  }

  /// A read of data in flash: a line of its own, which pushes out the one that instructions come from.
  void read_flash() {
    if (flash != FlashModel::miss_always) return;
    charge(flash_wait);
    line = kNoLine;
  }

  [[nodiscard]] bool is_flash(std::uint32_t address) const {
    return address - Memories::kFlashBase < Memories::kFlashBytes || (address < Memories::kFlashBytes && !ram_at_zero);
  }

  /// Inside the block of an IT instruction, past its first boundary.
  [[nodiscard]] bool in_it_block(std::uint32_t address) const { return address > it_begin && address < it_end; }

  /// Charges an instruction. @tparam Cost, Flash  what `cost` and `flash` say
  template <CostModel Cost, FlashModel Flash>
  void account(std::uint32_t address, unsigned cycles) {
    if constexpr (Flash == FlashModel::miss_always) {
      if ((address >> 4) != line) {
        line = address >> 4;
        if (is_flash(address)) time += flash_wait * cycle;
      }
    }
    time += Cost == CostModel::qemu ? kQemuInstruction : cycles * cycle;
    ++instructions;
  }
  /// Takes back the cycles of an instruction that was charged.
  void undo(unsigned cycles) {
    time -= cost == CostModel::qemu ? kQemuInstruction : cycles * cycle;
    --instructions;
  }
};

}  // namespace finemote::emulator
