// refused: a jump back to a place that was kept in memory
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {
inline volatile std::uint32_t x = 3;
inline volatile std::uint32_t tries = 0;
inline std::uint32_t place;

[[gnu::naked, gnu::noipa, gnu::returns_twice]] inline int keep_place(std::uint32_t*) {
  asm volatile("str lr, [r0]\n movs r0, #0\n bx lr");
}
[[gnu::naked, gnu::noipa]] inline void go_back(std::uint32_t*) { asm volatile("ldr lr, [r0]\n movs r0, #1\n bx lr"); }

class Walker {
 public:
  void update() { go(); }
  [[gnu::noipa]] void go() {
    tries = 0;
    keep_place(&place);
    tries = tries + 1;
    if (tries < 200) go_back(&place);
  }
  void handle() {}
  finemote::Stamp state;
};
}  // namespace my
