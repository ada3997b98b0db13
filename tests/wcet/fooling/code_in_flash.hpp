// refused: code that stays in flash is slower than the rest
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

[[gnu::section(".boot"), gnu::noinline, gnu::long_call]] inline void cold(volatile std::uint32_t& x) {
  for (std::uint32_t i = 0; i < 100; ++i) x = x * 5 / 3;
}

struct Walker {
  void update() { cold(x_); }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t x_ = 3;
};
}  // namespace my
