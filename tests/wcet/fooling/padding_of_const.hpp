// bounded: what lies in the padding behind a constant is none
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
    rounds_ = static_cast<std::uint8_t>(seen_ + 200);
    for (unsigned i = 0; i < rounds_; ++i) seen_ = i;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  [[no_unique_address]] const Limits limits_{4, 1};
  std::uint8_t rounds_ = 2;
  volatile std::uint32_t seen_ = 0;

 public:
  [[nodiscard]] const Limits& limits() const { return limits_; }
};
}  // namespace my
