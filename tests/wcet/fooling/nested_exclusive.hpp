// bounded: an exclusive store fails after another exclusive access
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {
inline volatile std::uint32_t x = 3;
inline std::uint32_t word = 0, other = 0;

class Walker {
 public:
  void update() {
    std::uint32_t failed = 1;
    for (int k = 0; k < 50 && failed != 0; ++k) {
      std::uint32_t old;
      asm volatile("ldrex %0, [%1]" : "=r"(old) : "r"(&word) : "memory");
      __atomic_fetch_add(&other, 1, __ATOMIC_RELAXED);
      asm volatile("strex %0, %2, [%1]" : "=&r"(failed) : "r"(&word), "r"(old + 1) : "memory");
    }
  }
  void handle() {}
  finemote::Stamp state;
};
}  // namespace my
