// refused: a wait that keeps the last three values
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {
/// The cycle count of the core: DWT_CYCCNT.
inline std::uint32_t cycles() { return *reinterpret_cast<const volatile std::uint32_t*>(0xE0001004); }

struct Walker {
  void update() {
    std::uint32_t newest = head_, middle = newest, oldest = newest;
    const std::uint32_t first = newest;
    const std::uint32_t begin = cycles();
    const finemote::WaitBound wait(400);
    while (cycles() - begin < 400) {
      wait.pass();
      oldest = middle;
      middle = newest;
      head_ = head_ + 40;  // more has come
      newest = head_;
    }
    for (std::uint32_t at = first; at != oldest; ++at) x_ = x_ * 5 / 3;
    x_ = newest + middle;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t head_ = 0, x_ = 3;
};
}  // namespace my
