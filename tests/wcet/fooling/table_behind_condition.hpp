// refused: the comparison before a table is in an IT block
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    const std::uint32_t k = x_, on = y_;
    // if (on != 0 && k > 1) return; k is at most 3: three ways do nothing, the fourth is long
    asm goto(
        "cmp %1, #0\n\tit ne\n\tcmpne %0, #1\n\tbhi %l[out]\n\ttbb [pc, %0]\n"
        "0: .byte (%l[out] - 0b) / 2, (%l[out] - 0b) / 2, (%l[out] - 0b) / 2, (1f - 0b) / 2\n\t.balign 2\n"
        "1: b %l[far]"
        :
        : "r"(k), "r"(on)
        : "cc", "memory"
        : out, far);
  out:
    return;
  far:
    for (std::uint32_t i = 0; i < 100; ++i) z_ = z_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t x_ = 3, y_ = 0, z_ = 7;
};
}  // namespace my
