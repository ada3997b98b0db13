// bounded: a wait of zero cycles, whose loop the compiler leaves out: its mark lies in the loop around it, and says
// nothing
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {
/// The cycle count of the core: DWT_CYCCNT.
inline std::uint32_t cycles() { return *reinterpret_cast<const volatile std::uint32_t*>(0xE0001004); }

template <std::uint32_t limit>
inline bool wait_for(const volatile std::uint32_t& flag) {
  const std::uint32_t begin = cycles();
  const finemote::WaitBound wait(limit);
  do {
    wait.pass();
    if (flag != 0) return true;
  } while (cycles() - begin < limit);
  return false;
}
struct Walker {
  void update() {
    for (std::uint32_t i = 0; i < 40; ++i) {
      if (!wait_for<0>(ready_)) work();
    }
  }
  void handle() {}
  finemote::Stamp state;

 private:
  [[gnu::noinline]] void work() {
    for (std::uint32_t i = 0; i < 20; ++i) x_ = x_ * 5 / 3;
  }
  volatile std::uint32_t ready_ = 0, x_ = 3;
};
}  // namespace my
