// refused: a const member that a constructor sets before main
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    for (std::uint32_t i = 0; i < count_; ++i) x_ = x_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
 public:
  Walker() : count_(read()) {}

 private:
  [[gnu::noinline]] static std::uint32_t read() {
    volatile std::uint32_t v = 40;
    return v;
  }
  volatile std::uint32_t x_ = 3;
  const std::uint32_t count_;
};
}  // namespace my
