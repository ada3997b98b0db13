// bounded: a comparison that an instruction after it leaves alone
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    std::uint32_t a = m_, b = n_ + 5, r = 0;
    asm volatile("cmp %1, #16\n\tcbz %2, 1f\n\tbne 1f\n\tmovs %0, #40\n1:" : "+l"(r) : "l"(a), "l"(b) : "cc");
    for (std::uint32_t i = 0; i < r; ++i) x_ = x_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t n_ = 0, x_ = 3, m_ = 16, o_ = 10;
};
}  // namespace my
