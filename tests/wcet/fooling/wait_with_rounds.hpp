// bounded: a wait with two marks, in a loop: at most 3 iterations, and left after 100 cycles
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {
/// The cycle count of the core: DWT_CYCCNT.
inline std::uint32_t cycles() { return *reinterpret_cast<const volatile std::uint32_t*>(0xE0001004); }

struct Walker {
  void update() {
    for (std::uint32_t i = 0; i < 40; ++i) {
      const std::uint32_t begin = cycles();
      const finemote::WaitBound wait(100);
      const finemote::LoopBound<3> rounds;
      while (ready_ == 0 && cycles() - begin < 100) {
        wait.pass();
        asked_ = asked_ + 1;
        rounds.pass();
        work();
      }
    }
  }
  void handle() {}
  finemote::Stamp state;

 private:
  [[gnu::noinline]] void work() {
    for (std::uint32_t i = 0; i < 20; ++i) x_ = x_ * 5 / 3;
  }
  volatile std::uint32_t ready_ = 0, asked_ = 0, x_ = 3;
};
}  // namespace my
