// bounded: the same of an array: its elements may be anything
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    static const Table table = make();
    for (std::uint32_t i = 0; i < table.n[k_ & 3]; ++i) x_ = x_ * 5 / 3;
    k_ = k_ + 1;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  struct Table {
    std::uint8_t n[4];
  };
  [[gnu::noinline]] static Table make() {
    Table t;
    for (std::uint32_t i = 0; i < 4; ++i) t.n[i] = static_cast<std::uint8_t>(i * 13 + seed_);
    return t;
  }
  static inline volatile std::uint32_t seed_ = 1;
  volatile std::uint32_t x_ = 3, k_ = 0;
};
}  // namespace my
