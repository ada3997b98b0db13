// bounded: a constant member of a variable in a section of its own, which nothing fills
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Limits {
  constexpr Limits() {}
  const std::uint32_t rounds = 3;
  std::uint32_t other = 1;
};
[[gnu::section("my_state")]] inline Limits limits;
struct Walker {
  void update() {
    for (std::uint32_t i = 0; i < limits.rounds && i < 500; ++i) z_ = z_ * 5 / 3;
    limits.other = z_;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t z_ = 7;
};
}  // namespace my
