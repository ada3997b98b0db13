// refused: how often an exclusive store was tried is counted, and work hangs on that
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {
inline volatile std::uint32_t x = 3;
inline std::uint32_t word = 0;

class Walker {
 public:
  void update() {
    std::uint32_t old, failed, tries = 0;
    do {
      asm volatile("ldrex %0, [%1]" : "=r"(old) : "r"(&word) : "memory");
      asm volatile("strex %0, %2, [%1]" : "=&r"(failed) : "r"(&word), "r"(old + 1) : "memory");
      ++tries;
    } while (failed != 0);
    for (std::uint32_t k = 1; k < tries; ++k) {
      for (int i = 0; i < 400; ++i) x = x * 5 / 3;
    }
  }
  void handle() {}
  finemote::Stamp state;
};
}  // namespace my
