// bounded: by a remainder, by a table at a remainder, and by a number that is not negative
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {
struct Lengths {
  std::uint8_t of[6]{1, 2, 3, 4, 4, 4};
};
inline const Lengths lengths{};

class Walker {
 public:
  void update() {
    for (std::uint32_t i = 0; i < count_ % 10; ++i) x_ = x_ * 5 / 3;
    for (int i = 0; i < lengths.of[count_ % 6]; ++i) x_ = x_ * 5 / 3;
    std::int32_t n = signed_;
    if (n < 0) n = 0;
    for (std::int32_t i = 0; i < n % 64; ++i) x_ = x_ * 5 / 3;
    count_ = count_ + 1;
    signed_ = static_cast<std::int32_t>(count_ * 0x12345677U);
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t x_ = 3, count_ = 3;
  volatile std::int32_t signed_ = 100;
};
}  // namespace my
