// refused: an interrupt makes long work begin anew whose exclusive store is in another function
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {
inline volatile std::uint32_t x = 3;
inline std::uint32_t word = 0;

[[gnu::noipa]] inline std::uint32_t put(std::uint32_t value) {
  std::uint32_t failed;
  asm volatile("strex %0, %2, [%1]" : "=&r"(failed) : "r"(&word), "r"(value) : "memory");
  return failed;
}

class Walker {
 public:
  void update() {
    std::uint32_t old;
    do {
      asm volatile("ldrex %0, [%1]" : "=r"(old) : "r"(&word) : "memory");
      for (int i = 0; i < 400; ++i) x = x * 5 / 3;
    } while (put(old + 1) != 0);
  }
  void handle() {}
  finemote::Stamp state;
};
}  // namespace my
