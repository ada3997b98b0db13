// refused: a loop that begins with a wait: both begin at the same place
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {
/// The cycle count of the core: DWT_CYCCNT.
inline std::uint32_t cycles() { return *reinterpret_cast<const volatile std::uint32_t*>(0xE0001004); }

struct Walker {
  void update() {
    const std::uint32_t begin = cycles();
    std::uint32_t left = 40;
    const finemote::WaitBound wait(100);
    do {
      while (filled_ == 0) {  // the next one has not come yet
        wait.pass();
        if (cycles() - begin >= 100) return;
      }
      work();
    } while (--left != 0);
  }
  void handle() {}
  finemote::Stamp state;

 private:
  [[gnu::noinline]] void work() {
    for (std::uint32_t i = 0; i < 20; ++i) x_ = x_ * 5 / 3;
  }
  volatile std::uint32_t filled_ = 1, x_ = 3;
};
}  // namespace my
