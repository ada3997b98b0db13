// bounded: an 8-bit member on the stack that wraps
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    // a small ring on the stack: 8-bit indices that wrap
    Ring ring{};
    for (std::uint32_t i = 0; i < 3; ++i) ring.put(100);
    drain(ring);
  }
  void handle() {}
  finemote::Stamp state;

 private:
  struct Ring {
    std::uint8_t head = 0, tail = 0;
    [[gnu::noipa]] void put(std::uint32_t n) { head = static_cast<std::uint8_t>(head + n); }
  };
  // 300 % 256 = 44 entries: 300 is not more than 255
  [[gnu::noipa]] void drain(const Ring& r) {
    if (r.head < 100)
      for (std::uint32_t i = 0; i < 40; ++i) x_ = x_ * 5 / 3;
  }
  volatile std::uint32_t x_ = 3;
};
}  // namespace my
