// bounded: of a byte on the stack only eight bits come back
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    std::uint8_t frame[4];
    frame[0] = static_cast<std::uint8_t>(first_);
    frame[1] = static_cast<std::uint8_t>(x_);
    work(frame);
  }
  void handle() {}
  finemote::Stamp state;

 private:
  [[gnu::noipa]] void work(const std::uint8_t* frame) {
    for (std::uint32_t i = frame[0]; i < 300; ++i) x_ = x_ * 5 / 3;
    y_ = frame[1];
  }
  volatile std::uint32_t x_ = 3, y_ = 0;
  const std::uint32_t first_ = 296;
};
}  // namespace my
