// bounded: the way after an exclusive store that an interrupt makes fail, where no loop tries again
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {
inline volatile std::uint32_t x = 3;
inline std::uint32_t word = 0;

class Walker {
 public:
  void update() {
    std::uint32_t old, failed;
    asm volatile("ldrex %0, [%1]" : "=r"(old) : "r"(&word) : "memory");
    for (int i = 0; i < 950; ++i) x = x * 5 / 3;
    asm volatile("strex %0, %2, [%1]" : "=&r"(failed) : "r"(&word), "r"(old + 1) : "memory");
    if (failed != 0) {
      for (int i = 0; i < 900; ++i) x = x * 5 / 3;
    }
  }
  void handle() {}
  finemote::Stamp state;
};
}  // namespace my
