// refused: a pointer to a local is put into a member as a float, and taken from there
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    std::uint32_t rounds = 1;
    put(&rounds);
    answer();
    for (std::uint32_t i = 0; i < rounds; ++i) x_ = x_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  [[gnu::noipa]] void put(const std::uint32_t* where) {
    float kept;
    asm volatile("vmov %0, %1" : "=t"(kept) : "r"(where));
    kept_ = kept;
  }
  [[gnu::noipa]] void answer() {
    std::uint32_t* where;
    asm volatile("vmov %0, %1" : "=r"(where) : "t"(static_cast<float>(kept_)));
    *where = 40;
  }
  volatile float kept_ = 0;
  volatile std::uint32_t x_ = 3;
};
}  // namespace my
