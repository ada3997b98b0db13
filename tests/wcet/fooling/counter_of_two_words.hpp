// bounded: a counter that is multiplied to 64 bits counts in two words
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {
class Walker {
 public:
  void update() {
    for (std::int32_t i = 0; i < 20; ++i) out_ = out_ + static_cast<std::int32_t>((std::int64_t{gain_} * i) >> 16U);
    for (std::uint64_t i = 0x1'0000'0003; i > 0xFFFF'FFF9; --i) out_ = out_ * 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::int32_t gain_ = 7, out_ = 0;
};
}  // namespace my
