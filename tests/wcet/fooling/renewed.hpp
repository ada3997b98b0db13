// refused: an object with a const member that is made anew
#pragma once

#include <cstdint>
#include <new>

#include "finemote/contract.hpp"

namespace my {
struct Slot {
  const std::uint32_t count;
};
struct Walker {
  void update() {
    if (x_ != 0) {
      renew();
    }
    for (std::uint32_t i = 0; i < std::launder(&slot_)->count; ++i) x_ = x_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t x_ = 3;
  [[gnu::noinline]] void renew() {
    slot_.~Slot();
    new (&slot_) my::Slot{40};
  }
  my::Slot slot_{1};
};
}  // namespace my
