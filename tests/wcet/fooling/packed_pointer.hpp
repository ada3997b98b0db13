// refused: a pointer to a local becomes four bytes of a member
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    std::uint32_t rounds = 1;
    pack(reinterpret_cast<std::uintptr_t>(&rounds));
    answer();
    for (std::uint32_t i = 0; i < rounds; ++i) x_ = x_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  [[gnu::noipa]] void pack(std::uintptr_t where) {
    for (volatile std::uint8_t& byte : message_) {
      byte = static_cast<std::uint8_t>(where);
      where >>= 8;
    }
  }
  [[gnu::noipa]] void answer() {
    std::uintptr_t where = 0;
    for (std::uint32_t i = 4; i-- > 0;) where = where << 8 | message_[i];
    *reinterpret_cast<std::uint32_t*>(where) = 40;
  }
  volatile std::uint8_t message_[4] = {};
  volatile std::uint32_t x_ = 3;
};
}  // namespace my
