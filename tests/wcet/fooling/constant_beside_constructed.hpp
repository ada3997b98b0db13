// refused: a const member is set before main, and what lies beside it is in the image
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

[[gnu::noinline]] inline std::uint32_t read() {
  volatile std::uint32_t v = 40;
  return v;
}
/// Like Walker() it is set before main.
struct Limits {
  const std::uint32_t low;
  const std::uint32_t high;
};
inline Limits limits{5, read()};
struct Walker {
  void update() {
    for (std::uint32_t i = 0; i < limits.high; ++i) x_ = x_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t x_ = 3;
};
}  // namespace my
