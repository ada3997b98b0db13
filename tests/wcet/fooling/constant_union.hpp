// bounded: what lies in the padding after a constant union is none
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {
inline volatile std::uint32_t x = 3;
union Bytes {
  std::uint32_t word;
  std::uint8_t byte[5];
  constexpr Bytes() : byte{1, 2, 3, 4, 5} {}
  constexpr Bytes(const Bytes& other) : word(other.word) {}
};

class Walker {
 public:
  void update() {
    rounds_[x & 1] = 200;
    rounds_[~x & 1] = 200;
    for (unsigned i = 0; i < rounds_[0]; ++i) x = x * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  [[no_unique_address]] const Bytes bytes_{};
  std::uint8_t rounds_[2] = {5, 6};
};
}  // namespace my
