// refused: a naked function with a routine of its own that keeps the link register on the stack
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

[[gnu::naked, gnu::noinline]] inline std::uint32_t work(std::uint32_t) {
  asm("push {r4, lr}\n\tlsrs r4, r0, #1\n\tbcc 2f\n\tbl 1f\n\tmovs r4, #200\n"
      "3: muls r0, r4, r0\n\tudiv r0, r0, r4\n\tsubs r4, #1\n\tbne 3b\n2: pop {r4, pc}\n"
      "1: push {r4, lr}\n\tadds r0, #2\n\tpop {r4, pc}");
}
struct Walker {
  void update() {
    z_ = work(x_);
    x_ = x_ + 1;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t x_ = 0, z_ = 7;
};
}  // namespace my
