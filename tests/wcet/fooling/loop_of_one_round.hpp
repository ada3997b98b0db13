// refused: a loop of one round, which the compiler leaves out: its mark lies in the loop around it
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {

struct Walker {
  void update() {
    for (std::uint32_t k = 0; k < o_; ++k) {
      finemote::loop_bound<10>();
      for (volatile std::uint32_t& e : array_) {
        finemote::loop_bound<1>();
        e = e * 3 + k;
      }
    }
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t n_ = 0, x_ = 0, m_ = 16, o_ = 10;
  volatile std::uint32_t array_[1] = {};
};
}  // namespace my
