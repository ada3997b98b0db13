// refused: a jump to a function that returns to after it
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {
inline volatile std::uint32_t x = 3;
extern "C" [[gnu::used, gnu::noinline]] inline void fm_small() { x = x + 1; }

class Walker {
 public:
  void update() { call(); }
  [[gnu::noinline]] void call() {
    asm volatile("push {r4, lr}\n adr lr, 1f\n orr lr, lr, #1\n b fm_small\n .balign 4\n1: nop\n pop {r4, lr}" ::
                     : "r0", "r1", "r2", "r3", "r12", "cc", "memory");
    for (int i = 0; i < 400; ++i) x = x * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;
};
}  // namespace my
