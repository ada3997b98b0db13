// refused: links of 16 bits between locals
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    Node last{1, 0};
    Node first{1, link_to(last)};
    answer(first);
    for (std::uint32_t i = 0; i < last.rounds; ++i) x_ = x_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  static constexpr std::uintptr_t kMemory = 0x10000000;
  struct Node {
    std::uint32_t rounds;
    std::uint16_t next;
  };
  [[gnu::noipa]] static std::uint16_t link_to(const Node& node) {
    return static_cast<std::uint16_t>(reinterpret_cast<std::uintptr_t>(&node) - kMemory);
  }
  [[gnu::noipa]] static void answer(const Node& node) { reinterpret_cast<Node*>(kMemory + node.next)->rounds = 40; }
  volatile std::uint32_t x_ = 3;
};
}  // namespace my
