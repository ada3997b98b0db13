// refused: a part of a function goes on in another function, on one of two ways
#pragma once

#include <cstdint>

#include <cstring>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

extern "C" [[gnu::noinline, gnu::used]] inline void my_empty_one() { asm volatile(""); }

namespace my {

struct Walker {
  void update() {
    if ((x_ & 1) != 0) {
      asm volatile("b 2f\n1: nop\n b my_empty_one\n2: bl 1b\n" ::: "r0", "r1", "r2", "r3", "r12", "lr", "cc", "memory");
      my_empty_one();
      for (std::uint32_t i = 0; i < 100; ++i) z_ = z_ * 5 / 3;
    }
    x_ = x_ + 1;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t x_ = 0, z_ = 7;
};
}  // namespace my
