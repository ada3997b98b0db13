// bounded: a mark outside of a loop says nothing, and cuts no way
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {
class Walker {
 public:
  void update() {
    const finemote::LoopBound<0> never;
    if (count_ % 4 == 3) {
      never.pass();
      for (int i = 0; i < 100; ++i) x_ = x_ * 5 / 3;
    }
    count_ = count_ + 1;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t x_ = 3, count_ = 0;
};
}  // namespace my
