// refused: how far a place on the stack is from a multiple of 64 depends on what was preempted
#pragma once

#include <cstdint>
#include <cstring>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    std::uint8_t buffer[96];
    std::uint8_t* p = buffer;
    touch(p);
    while (((reinterpret_cast<std::uintptr_t>(p) + 56U) & 63U) != 0) {
      ++p;
      x_ = x_ * 5 / 3;
    }
    touch(p);
  }
  void handle() {}
  finemote::Stamp state;

 private:
  [[gnu::noinline]] static void touch(std::uint8_t* p) { asm volatile("" : : "r"(p) : "memory"); }
  volatile std::uint32_t x_ = 3;
};
}  // namespace my
