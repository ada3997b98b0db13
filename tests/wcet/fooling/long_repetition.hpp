// refused: an interrupt makes long work between exclusive accesses begin anew
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {
inline volatile std::uint32_t x = 3;
inline std::uint32_t word = 0;

class Walker {
 public:
  void update() {
    std::uint32_t failed;
    do {
      std::uint32_t old;
      asm volatile("ldrex %0, [%1]" : "=r"(old) : "r"(&word) : "memory");
      for (int i = 0; i < 400; ++i) x = x * 5 / 3;
      asm volatile("strex %0, %2, [%1]" : "=&r"(failed) : "r"(&word), "r"(old + 1) : "memory");
    } while (failed != 0);
  }
  void handle() {}
  finemote::Stamp state;
};
}  // namespace my
