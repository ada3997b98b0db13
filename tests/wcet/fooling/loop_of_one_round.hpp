// bounded: a loop of one iteration that the compiler leaves out: its mark lies in the loop around it and says nothing
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {

struct Walker {
  void update() {
    const finemote::LoopBound<10> rows;
    for (std::uint32_t k = 0; k < o_; ++k) {
      rows.pass();
      const finemote::LoopBound<1> entries;
      for (volatile std::uint32_t& e : array_) {
        entries.pass();
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
