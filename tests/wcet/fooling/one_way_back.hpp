// refused: two loops of which the compiler makes one with one way back; the inner one alone has a mark
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {
struct Walker {
  void update() {
    at_ = 0;
    while (true) {  // lines: nobody says how many
      const finemote::LoopBound<8> letters;
      while (true) {
        letters.pass();  // letters of a line, its end included
        const std::uint32_t letter = next();
        if (letter == 0) return;
        if (letter == 10) break;
      }
    }
  }
  void handle() {}
  finemote::Stamp state;

 private:
  [[gnu::noinline]] std::uint32_t next() {
    const std::uint32_t n = at_ + 1;
    at_ = n;
    return n == 60 ? 0 : n % 8 == 0 ? 10 : 65;
  }
  volatile std::uint32_t at_ = 0;
};
}  // namespace my
