// refused: a jump back out of a function
#pragma once

#include <csetjmp>
#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    tries_ = 0;
    if (setjmp(back_) < 40) work();
  }
  void handle() {}
  finemote::Stamp state;

 private:
  [[gnu::noipa]] void work() {
    x_ = x_ * 5 / 3;
    tries_ = tries_ + 1;
    if (tries_ < 40) std::longjmp(back_, 1);
  }
  std::jmp_buf back_{};
  volatile std::uint32_t tries_ = 0, x_ = 3;
};
}  // namespace my
