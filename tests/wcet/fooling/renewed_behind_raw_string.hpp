// refused: an object with a const member is made anew after a raw string that looks like the start of a comment
#pragma once

#include <cstdint>
#include <new>

#include "finemote/contract.hpp"

namespace my {

struct Limits {
  const std::uint32_t rounds;
};
inline Limits limits{1};
inline const char* const kText = R"(" /*)";

struct Walker {
  Walker() {
    volatile std::uint32_t rounds = 40;
    limits.~Limits();
    new (&limits) Limits{rounds};
  }
  void update() {
    for (std::uint32_t i = 0; i < std::launder(&limits)->rounds; ++i) x_ = x_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t x_ = 3;
};
}  // namespace my
