// bounded: of a halfword on the stack only sixteen bits come back
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    std::uint16_t frame[4];
    frame[0] = static_cast<std::uint16_t>(base_ + (x_ & 3));
    frame[1] = static_cast<std::uint16_t>(x_);
    work(frame);
  }
  void handle() {}
  finemote::Stamp state;

 private:
  [[gnu::noipa]] void work(const std::uint16_t* frame) {
    for (std::uint32_t i = 0; i < 40; ++i)
      if (frame[0] < 100) x_ = x_ * 5 / 3;
    y_ = frame[1];
  }
  volatile std::uint32_t x_ = 3, y_ = 0;
  const std::uint32_t base_ = 65536 + 7;
};
}  // namespace my
