// refused: a pointer to a local goes through a register of the FPU
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    std::uint32_t rounds = 1;
    std::uint32_t* where = &rounds;
    float kept;
    asm volatile("vmov %0, %1" : "=t"(kept) : "r"(where));
    asm volatile("vmov %0, %1" : "=r"(where) : "t"(kept));
    *where = 40;
    for (std::uint32_t i = 0; i < rounds; ++i) x_ = x_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t x_ = 3;
};
}  // namespace my
