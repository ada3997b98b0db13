// bounded: a part of a function returns with pop
#pragma once

#include <cstdint>

#include <cstring>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {

struct Walker {
  void update() {
    asm volatile("b 2f\n1: push {r4, lr}\n nop\n pop {r4, pc}\n2: bl 1b\n" ::: "lr", "cc", "memory");
    for (std::uint32_t i = 0; i < 100; ++i) z_ = z_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t z_ = 7;
};
}  // namespace my
