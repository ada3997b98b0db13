// What can go wrong when the chip starts, and why it had to: the numbers behind Module::board.
#pragma once

#include <cstdint>

namespace finemote::stm32f4 {

enum class BoardFault : std::uint8_t {
  crystal = 1,   ///< the crystal does not start
  flash_wait,    ///< the flash does not take its wait states
  pll,           ///< the PLL does not lock
  clock_switch,  ///< the core does not change over to the PLL
  watchdog,      ///< the watchdog does not take its period
  restarted,     ///< a watchdog restarted the board
  brown_out,     ///< the supply sagged, and the board restarted
};

}  // namespace finemote::stm32f4
