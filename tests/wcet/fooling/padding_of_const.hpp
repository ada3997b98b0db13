// bounded: what lies in the padding after a constant is none
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Limits {
  constexpr Limits(std::uint32_t m, std::uint8_t l) : most(m), least(l) {}
  std::uint32_t most;
  std::uint8_t least;
};
struct Walker {
  void update() {
    rounds_[seen_ & 1] = static_cast<std::uint8_t>(limits_.most);
    for (unsigned i = 0; i < rounds_[1]; ++i) seen_ = seen_ + 1;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  [[no_unique_address]] const Limits limits_{40, 1};
  std::uint8_t rounds_[2] = {1, 1};
  volatile std::uint32_t seen_ = 3;
};
}  // namespace my
