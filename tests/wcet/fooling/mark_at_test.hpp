// bounded: a mark that lies before the test of its loop
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {

struct Walker {
  void update() { go(); }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t n_ = 0, x_ = 3, m_ = 2;
  [[gnu::noinline]] bool ended(std::uint32_t n) { return n >= m_; }
  [[gnu::noinline, gnu::optimize("O2")]] void go() {
    n_ = 0;
    const finemote::LoopBound<2> rounds;
    while (!ended(n_)) {
      spin();
      n_ = n_ + 1;
      rounds.pass();
    }
  }
  [[gnu::noipa]] void spin() {
    for (std::uint32_t i = 0; i < 100; ++i) x_ = x_ * 5 / 3;
  }
};
}  // namespace my
