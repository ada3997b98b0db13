// refused: pointers to locals are moved down in an array, byte by byte
#pragma once

#include <algorithm>
#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    std::uint32_t first = 1, second = 1;
    Queue queue{{&first, &second}, 2};
    pop(queue);
    *queue.items[0] = 40;
    for (std::uint32_t i = 0; i < count(second); ++i) x_ = x_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  struct Queue {
    std::uint32_t* items[3];
    std::uint32_t size;
  };
  [[gnu::noipa]] static void pop(Queue& queue) {
    std::copy(queue.items + 1, queue.items + queue.size, queue.items);
    --queue.size;
  }
  [[gnu::noipa]] static std::uint32_t count(const std::uint32_t& number) { return number; }
  volatile std::uint32_t x_ = 3;
};
}  // namespace my
