// bounded: a switch leads back to the starts of two loops, which begin apart with their marks
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {

struct Walker {
  void update() {
    at_ = 0;
    const finemote::LoopBound<8> lines;
    while (true) {
      lines.pass();
      const finemote::LoopBound<8> letters;
      while (true) {
        letters.pass();  // letters of a line
        switch (next()) {
          case 0:
            continue;
          case 1:
            continue;
          case 2:
            break;
          case 3:
            x_ = 1;
            return;
          case 4:
            continue;
          case 5:
            break;
          default:
            return;
        }
        break;
      }
    }
  }
  void handle() {}
  finemote::Stamp state;

 private:
  [[gnu::noinline]] std::uint32_t next() {
    const std::uint32_t n = at_ + 1;
    at_ = n;
    return n == 60 ? 3 : n % 8 == 0 ? 2 : 1;
  }
  volatile std::uint32_t at_ = 0, x_ = 3;
};
}  // namespace my
