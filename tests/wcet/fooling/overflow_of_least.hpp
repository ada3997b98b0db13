// bounded: adding the least number overflows the other way round than comparing with it
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    std::uint32_t r = x_;
    asm goto("mov.w r3, #0x80000000\n\tadds %0, %0, r3\n\tblt %l1" : : "r"(r) : "r3", "cc", "memory" : far);
    return;
  far:
    for (std::uint32_t i = 0; i < 100; ++i) x_ = x_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t x_ = 3;
};
}  // namespace my
