// refused: a pointer to a local is kept in a member, or on the stack
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    std::uint32_t rounds = 1;
    Slot own{nullptr};
    keep(is_own_ != 0 ? own : slot_, rounds);
    answer();
    for (std::uint32_t i = 0; i < rounds; ++i) x_ = x_ * 5 / 3;
    x_ = own.where != nullptr;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  struct Slot {
    std::uint32_t* where;
  };
  [[gnu::noipa]] static void keep(Slot& slot, std::uint32_t& rounds) { slot.where = &rounds; }
  [[gnu::noipa]] void answer() { *slot_.where = 40; }
  Slot slot_{nullptr};
  volatile std::uint32_t is_own_ = 0, x_ = 3;
};
}  // namespace my
