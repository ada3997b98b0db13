// refused: a local that a more urgent device may write at any time
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

inline volatile std::uint32_t* volatile asked = nullptr;

struct Walker {
  void update() {
    volatile std::uint32_t rounds = 1;
    asked = &rounds;
    for (std::uint32_t i = 0; i < 9000; ++i) x_ = x_ * 5 / 3;
    for (std::uint32_t i = 0; i < rounds; ++i) x_ = x_ * 5 / 3;
    asked = nullptr;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t x_ = 3;
};

struct Urgent {
  void update() {
    if (asked != nullptr) *asked = 9000;
  }
  void handle() {}
  finemote::Stamp state;
};
}  // namespace my
