// bounded: bits of a peripheral, by number
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

/// Single bits of a compare register of TIM2: RM0090 2.3.3 and 18.4.13.
inline volatile std::uint32_t& bit(std::uint32_t number) {
  return reinterpret_cast<volatile std::uint32_t*>(0x42000000 + 0x34 * 32)[number];
}

struct Walker {
  void update() {
    const std::uint32_t number = number_ & 15;
    for (unsigned i = 0; i < 32; ++i) {
      bit(number) = 1;
      bit(number) = 0;
    }
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t number_ = 3;
};
}  // namespace my
