// refused: a table after the place at which another function enters: the comparison is on the way back to it only
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

asm(".pushsection .text.my_ab,\"ax\",%progbits\n\t.balign 4\n\t"
    ".weak my_b\n\t.type my_b,%function\n\t.thumb_func\nmy_b: cmp r0, #1\n\tbhi 9f\n"
    "5: cbz r3, 7f\n\ttbb [pc, r0]\n6: .byte (9f-6b)/2, (9f-6b)/2, (9f-6b)/2, (8f-6b)/2\n"
    "7: movs r3, #1\n\tcmp r0, #1\n\tbls 5b\n9: bx lr\n"
    "8: movs r1, #200\n1: subs r1, #1\n\tbne 1b\n\tbx lr\n\t.size my_b, .-my_b\n"
    "\t.weak my_a\n\t.type my_a,%function\n\t.thumb_func\nmy_a: and r0, r0, #3\n\tmovs r3, #1\n\tb 5b\n\t.size my_a, "
    ".-my_a\n"
    "\t.popsection");
extern "C" std::uint32_t my_a(std::uint32_t x);

namespace my {

struct Walker {
  void update() {
    z_ = my_a(x_);
    x_ = x_ + 1;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t x_ = 0, z_ = 7;
};
}  // namespace my
