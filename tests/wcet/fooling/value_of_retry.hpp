// refused: what an exclusive store that failed was tried with again bounds a loop
#pragma once

#include <atomic>
#include <cstdint>

#include "finemote/contract.hpp"

namespace my {
inline volatile std::uint32_t x = 3;
inline std::atomic<std::uint32_t> word{5};

class Walker {
 public:
  void update() {
    std::uint32_t seen = 5;
    while (!word.compare_exchange_weak(seen, seen + 1, std::memory_order_relaxed)) {}
    for (std::uint32_t k = 0; k < seen; ++k) x = x * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;
};
}  // namespace my
