// What an image asks of a debugger with BKPT: Arm's semihosting, as far as images use it.
#include <cstring>

#include "emulator/core/cpu.hpp"
#include "emulator/core/word_text.hpp"

namespace finemote::emulator {

void Cpu::semihosting() {
  constexpr std::uint8_t kSemihosting = 0xAB;  // the number in BKPT
  const std::uint8_t* instruction = memory(pc(), 2);
  if (instruction == nullptr || *instruction != kSemihosting)
    return fault(kHardFault, 0, 0, "breakpoint at " + hex(pc()) + " without a debugger");
  Registers& g = core_.registers;
  const std::uint32_t operation = g.r[0];
  std::uint32_t argument = g.r[1];
  if (operation == 0x04) {  // SYS_WRITE0
    for (const std::uint8_t* p = memory(argument, 1); p != nullptr && *p != 0; p = memory(++argument, 1))
      console_ += static_cast<char>(*p);
  } else if (operation == 0x18 || operation == 0x20) {  // SYS_EXIT, SYS_EXIT_EXTENDED
    exited_ = true;
    if (const std::uint8_t* p = operation == 0x20 ? memory(argument + 4, 4) : nullptr) std::memcpy(&exit_code_, p, 4);
  } else if (operation == 0x10 || operation == 0x11) {
    g.r[0] = 0;
  } else {
    reports_.add(Misuse::unmodelled, "semihosting operation " + hex(operation), now(), pc());
  }
  g.next = pc() + 2;
  core_.pace.expected = g.next;
}

}  // namespace finemote::emulator
