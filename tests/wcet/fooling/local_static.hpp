// refused: a const variable of a function, which is read when it is first reached
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    static const std::uint32_t count = read();
    for (std::uint32_t i = 0; i < count; ++i) x_ = x_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  [[gnu::noinline]] static std::uint32_t read() {
    volatile std::uint32_t v = 40;
    return v;
  }
  volatile std::uint32_t x_ = 3;
};
}  // namespace my
