// bounded: a pointer into the stack, from which the distance to it is taken back
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    std::uint8_t text[16];
    text[0] = 1;
    const std::uint32_t n = k_ & 7;
    k_ = k_ + 1;
    finish(text + n, n);
    work(text);
  }
  void handle() {}
  finemote::Stamp state;

 private:
  [[gnu::noipa]] static void finish(std::uint8_t* end, std::uint32_t size) {
    for (std::uint8_t* p = end - size; p != end; ++p) *p = 40;
    *(end - size) = 40;
  }
  [[gnu::noipa]] void work(const std::uint8_t* t) {
    for (std::uint32_t i = 0; i < t[0]; ++i) x_ = x_ * 5 / 3;
  }
  volatile std::uint32_t x_ = 3, k_ = 0;
};
}  // namespace my
