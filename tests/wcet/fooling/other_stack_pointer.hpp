// refused: the stack pointer is set by MSR
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    std::uint32_t rounds;
    asm volatile(
        "mov r4, sp\n\t"
        "movs r5, #1\n\t"
        "push {r5}\n\t"
        "msr msp, %1\n\t"
        "isb\n\t"
        "pop {%0}\n\t"
        "mov sp, r4"
        : "=&l"(rounds)
        : "r"(&count_)
        : "r4", "r5", "memory");
    for (std::uint32_t i = 0; i < rounds; ++i) x_ = x_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t x_ = 3;
  std::uint32_t count_ = 40;
};
}  // namespace my
