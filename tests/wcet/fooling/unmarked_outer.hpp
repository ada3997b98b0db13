// refused: two loops that begin at one place, of which the inner one alone has a mark
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {

struct Walker {
  void update() {
    n_ = 0;
    do {
      const finemote::LoopBound<4> rounds;
      do {
        rounds.pass();
        n_ = n_ + 1;
      } while ((n_ & 3) != 0);
    } while (n_ != m_ * 4);
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t n_ = 0, x_ = 0, m_ = 16;
};
}  // namespace my
