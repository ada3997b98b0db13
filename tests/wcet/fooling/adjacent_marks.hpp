// bounded: marks of two loops side by side
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {

struct Walker {
  void update() {
    n_ = 0;
    const finemote::LoopBound<2> eights;
    do {
      eights.pass();
      const finemote::LoopBound<8> ones;
      do {
        ones.pass();
        n_ = n_ + 1;
      } while ((n_ & 7) != 0);
    } while ((n_ & 15) != 0);
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t n_ = 0, x_ = 0, m_ = 16;
};
}  // namespace my
