// bounded: a loop that begins with another one: their marks begin apart
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {

struct Walker {
  void update() {
    at_ = 0;
    const finemote::LoopBound<4> lines;
    while (true) {
      lines.pass();  // three lines, and the end
      std::uint32_t letter;
      const finemote::LoopBound<40> letters;
      do {
        letters.pass();  // letters of a line, its end included
        letter = next();
      } while (letter > 10);
      if (letter == 0) break;
    }
    sum_ = sum_ + 1;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t n_ = 0, x_ = 0, m_ = 16, o_ = 10;

  [[gnu::noinline]] std::uint32_t next() {
    const char c = text_[at_];
    at_ = at_ + 1;
    return static_cast<unsigned char>(c);
  }
  static constexpr const char* text_ = "first line of a text\nsecond line\nthe third one is here\n";
  volatile std::uint32_t at_ = 0, sum_ = 0;
};
}  // namespace my
