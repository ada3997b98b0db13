// refused: marks of two loops at one place
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {

struct Walker {
  void update() {
    n_ = 0;
    do {
      finemote::loop_bound<2>();
      do {
        finemote::loop_bound<8>();
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
