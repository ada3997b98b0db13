// refused: a const member of a class with a mutable member
#pragma once

#include <cstdint>
#include <cstring>

#include "finemote/contract.hpp"

namespace my {
struct Cache {
  mutable std::uint32_t count = 1;
  [[gnu::noinline]] void refresh() const {
    asm volatile("" ::: "memory");
    count = 40;
  }
};
struct Walker {
  void update() {
    cache_.refresh();
    for (std::uint32_t i = 0; i < cache_.count; ++i) x_ = x_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t x_ = 3;
  const my::Cache cache_{};
};
}  // namespace my
