// bounded: of a register that shifts only the lowest byte counts
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    std::uint32_t n = 40;
    asm volatile("mov r3, #256\n\tlsr %0, %0, r3" : "+r"(n) : : "r3", "cc");
    for (std::uint32_t i = 0; i < n; ++i) x_ = x_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t x_ = 3;
};
}  // namespace my
