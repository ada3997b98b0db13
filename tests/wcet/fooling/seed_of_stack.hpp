// bounded: a number of iterations made of where the stack is: any of six bits
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    const std::uint32_t here = 1;
    const std::uint32_t seed = mixed(&here, salt());
    for (std::uint32_t i = 0; i < (seed & 63); ++i) x_ = x_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  [[gnu::noipa]] static std::uint32_t salt() { return 50; }
  [[gnu::noipa]] static std::uint32_t mixed(const std::uint32_t* where, std::uint32_t salt) {
    return salt + (reinterpret_cast<std::uintptr_t>(where) >> 4);
  }
  volatile std::uint32_t x_ = 3;
};
}  // namespace my
