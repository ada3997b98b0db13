// What can go wrong in the Type C board's own code: the numbers behind Module::board.
#pragma once

#include <cstdint>

namespace finemote::robomaster_type_c {

enum class BoardFault : std::uint8_t {
  crystal = 1,   ///< the 12 MHz crystal does not start
  flash_wait,    ///< the flash does not take its wait states
  pll,           ///< the PLL does not lock
  clock_switch,  ///< the core does not change over to the PLL
  watchdog,      ///< the watchdog does not take its period
};

}  // namespace finemote::robomaster_type_c
