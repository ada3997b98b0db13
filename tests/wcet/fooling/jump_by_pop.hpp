// refused: a jump that looks like a return
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {
inline volatile std::uint32_t x = 3;
class Walker {
 public:
  void update() { call(); }
  [[gnu::noinline]] void call() {
    asm volatile("adr r0, 1f\n orr r0, r0, #1\n push {r0}\n pop {pc}\n .balign 4\n1: nop" ::
                     : "r0", "r1", "r2", "r3", "r12", "cc", "memory");
    for (int i = 0; i < 400; ++i) x = x * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;
};
}  // namespace my
