// bounded: products of halfwords: SMLATB, SMULTT, SMLALBB
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    const std::int32_t a = a_, b = b_;
    c_ = added(a, b, c_);
    d_ = both(a, b);
    e_ = summed(e_, static_cast<std::int16_t>(a), static_cast<std::int16_t>(b));
  }
  void handle() {}
  finemote::Stamp state;

 private:
  static std::int16_t top(std::int32_t v) { return static_cast<std::int16_t>(v >> 16); }
  [[gnu::noipa]] static std::int32_t added(std::int32_t a, std::int32_t b, std::int32_t c) {
    return c + top(a) * static_cast<std::int16_t>(b);
  }
  [[gnu::noipa]] static std::int32_t both(std::int32_t a, std::int32_t b) { return top(a) * top(b); }
  [[gnu::noipa]] static std::int64_t summed(std::int64_t sum, std::int16_t a, std::int16_t b) {
    return sum + std::int32_t{a} * b;
  }
  volatile std::int32_t a_ = 3, b_ = 4, c_ = 0, d_ = 0;
  std::int64_t e_ = 0;
};
}  // namespace my
