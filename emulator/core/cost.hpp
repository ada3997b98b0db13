// What an instruction costs: the choice of timing model.
#pragma once

namespace finemote::emulator {

enum class CostModel {
  cortex_m4,  ///< cycles per instruction class and per exception, Cortex-M4 TRM (DDI 0439); instruction-derived
  qemu,       ///< 8 ns per instruction and free exceptions, as `qemu-system-arm -icount shift=3` counts
};

enum class FlashModel {
  hit,          ///< the accelerator always has the line: RM0090 3.5.2 claims the equivalent of no wait state
  miss_always,  ///< every new 128-bit line costs the wait states
};

}  // namespace finemote::emulator
