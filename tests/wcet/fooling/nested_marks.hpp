// bounded: nested loops with marks and counters, in a moment
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"

namespace my {

struct Walker {
  void update() {
    const finemote::LoopBound<4> rows;
    for (std::uint32_t i = 0; i < rows_; ++i) {
      rows.pass();
      const finemote::LoopBound<4> columns;
      for (std::uint32_t j = 0; j < columns_; ++j) {
        columns.pass();
        const finemote::LoopBound<4> inner;
        for (std::uint32_t k = 0; k < inner_; ++k) {
          inner.pass();
          x_ = x_ + i * j + k;
        }
      }
    }
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t rows_ = 4, columns_ = 4, inner_ = 4, x_ = 3;
};
}  // namespace my
