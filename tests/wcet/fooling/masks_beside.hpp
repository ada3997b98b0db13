// refused: FAULTMASK is set in a block that a masked section of the runtime begins or ends
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "runtime/chips/cortex_m4/core.hpp"

namespace my {

struct Walker {
  void update() {
    {
      finemote::cortex_m4::Masked m;
      asm volatile("cpsid f" ::: "memory");
    }
    for (int i = 0; i < 30; ++i) z_ = z_ * 5 / 3;
    asm volatile("cpsie f" ::: "memory");
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t z_ = 7;
};
}  // namespace my
