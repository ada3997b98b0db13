// refused: interrupts are kept out, which delays what is not in this stage
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    asm volatile("cpsid i" ::: "memory");
    x_ = x_ * 5 / 3;
    asm volatile("cpsie i" ::: "memory");
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t x_ = 3;
};

}  // namespace my
