// refused: a mutable member whose word a macro makes
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

#define PASTE(a, b) a##b

namespace my {
inline volatile std::uint32_t x = 3;

struct Count {
  PASTE(mut, able) std::uint32_t rounds[2] = {3, 3};
  void grow(unsigned i) const { rounds[i & 1] = 200; }
};

class Walker {
 public:
  void update() {
    count_.grow(x);
    count_.grow(x + 1);
    for (std::uint32_t i = 0; i < count_.rounds[0]; ++i) x = x * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  const Count count_{};
};
}  // namespace my
