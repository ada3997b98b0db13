// How a board's chip makes its clocks, and where its memory lies: what the runtime is compiled with.
#pragma once

#include <cstdint>
#include <string>

namespace finemote::gen {

struct Clocks {
  std::uint32_t crystal_hz = 0;
  std::uint32_t pll_m = 0, pll_n = 0, pll_p = 0, pll_q = 0;  ///< RM0090 7.3.2
  std::uint32_t apb1_hz = 0, apb2_hz = 0;
  std::uint32_t flash_wait_states = 0;
};

struct Memory {
  std::string name;    ///< flash, ram, ccm
  std::string origin;  ///< `0x08000000`
  std::uint32_t bytes = 0;
};

}  // namespace finemote::gen
