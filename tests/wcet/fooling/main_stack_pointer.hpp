// refused: the stack pointer is read as CMSIS does
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    volatile std::uint32_t rounds = 3;
    std::uint32_t sp;
    asm volatile("mrs %0, msp" : "=r"(sp) : : "memory");
    auto* p = reinterpret_cast<volatile std::uint32_t*>(sp);
    for (std::uint32_t k = 0; k < 2; ++k)
      if (p[k] == 3) p[k] = 40;
    const std::uint32_t n = rounds;
    for (std::uint32_t i = 0; i < n; ++i) x_ = x_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t x_ = 3;
};
}  // namespace my
