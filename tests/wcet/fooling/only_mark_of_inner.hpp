// refused: a loop without a mark around one of one iteration, whose mark is left
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {

template <std::uint32_t channels>
struct Filter {
  volatile std::uint32_t x = 3;
  void run() {
    std::uint32_t channel = 0;
    const finemote::LoopBound<channels> all;
    do {
      all.pass();
      x = x * 5 / 3 + channel;
    } while (++channel < channels);
  }
};
struct Walker {
  void update() {
    while (left_ != 0) {  // nobody says how often
      filter_.run();
      left_ = left_ - 1;
    }
    left_ = 40;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  Filter<1> filter_;
  volatile std::uint32_t left_ = 40;
};
}  // namespace my
