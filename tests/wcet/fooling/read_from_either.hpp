// refused: a kept pointer to a local is read from a member, or from the stack
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    std::uint32_t rounds = 1, other = 0;
    keep(rounds);
    Slot own{&other};
    answer(is_own_ != 0 ? own : slot_);
    for (std::uint32_t i = 0; i < rounds; ++i) x_ = x_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  struct Slot {
    std::uint32_t* where;
  };
  [[gnu::noipa]] void keep(std::uint32_t& rounds) { slot_.where = &rounds; }
  [[gnu::noipa]] static void answer(const Slot& slot) { *slot.where = 40; }
  Slot slot_{nullptr};
  volatile std::uint32_t is_own_ = 0, x_ = 3;
};
}  // namespace my
