// bounded: nested loops with marks and a larger body, in a moment
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {

struct Walker {
  void update() {
    const finemote::LoopBound<6> rows;
    for (std::uint32_t i = 0; i < rows_; ++i) {
      rows.pass();
      const finemote::LoopBound<6> columns;
      for (std::uint32_t j = 0; j < columns_; ++j) {
        columns.pass();
        x_ = x_ + i * j;
        for (std::uint32_t k = 0; k < 3; ++k) one(k + j);
      }
    }
  }
  void handle() {}
  finemote::Stamp state;

 private:
  [[gnu::noinline]] void one(std::uint32_t k) {
    if (x_ > k)
      x_ = x_ + k;
    else
      x_ = x_ * 3;
    if (rows_ > 7) x_ = x_ + 5;
  }
  volatile std::uint32_t rows_ = 6, columns_ = 6, x_ = 3;
};
}  // namespace my
