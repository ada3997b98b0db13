// refused: a wait puts a pointer to a local where nothing was before, and writes through it in the next iteration
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {

inline std::uint32_t cycles() { return *reinterpret_cast<const volatile std::uint32_t*>(0xE0001004); }
struct Walker {
  void update() {
    volatile std::uint32_t rounds = 3;
    volatile std::uint32_t* volatile link;
    volatile std::uint32_t room[12];
    room[0] = 1;
    has_link_ = 0;
    const std::uint32_t begin = cycles();
    const finemote::WaitBound wait(400);
    while (cycles() - begin < 400) {
      wait.pass();
      if (has_link_ != 0) *link = 40;
      link = &rounds;
      has_link_ = 1;
    }
    const std::uint32_t n = rounds;
    for (std::uint32_t i = 0; i < n; ++i) x_ = x_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t x_ = 3, has_link_ = 0;
};
}  // namespace my
