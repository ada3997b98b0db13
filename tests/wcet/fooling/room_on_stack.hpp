// bounded: the long way is for a stack of which others have used something
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

extern "C" std::uint32_t _stack_top;

namespace my {

struct Walker {
  void update() {
    const std::uint32_t here = 1;
    if (used(&here) < 64) return;
    for (std::uint32_t i = 0; i < 40; ++i) x_ = x_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  [[gnu::noipa]] static std::uint32_t used(const std::uint32_t* where) {
    return reinterpret_cast<std::uintptr_t>(&_stack_top) - reinterpret_cast<std::uintptr_t>(where);
  }
  volatile std::uint32_t x_ = 3;
};
}  // namespace my
