// refused: a loop that is entered in its middle, inside another one
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {

struct Walker {
  void update() { duff(); }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t n_ = 0, x_ = 0, m_ = 16, o_ = 10;
  volatile std::uint32_t which_ = 1;
  [[gnu::noinline]] void duff() {
    for (std::uint32_t k = 0; k < o_; ++k) {
      std::uint32_t left = m_ / 8;
      const finemote::LoopBound<2> eights;
      switch (which_ & 3) {
        case 0:
          do {
            x_ = x_ + 1;
            [[fallthrough]];
            case 3:
              x_ = x_ * 2;
              [[fallthrough]];
            case 2:
              x_ = x_ + 5;
              [[fallthrough]];
            case 1:
              x_ = x_ * 7;
              eights.pass();
          } while (--left > 0);
      }
    }
  }
};
}  // namespace my
