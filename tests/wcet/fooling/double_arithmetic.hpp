// refused: arithmetic on double, which libgcc does with parts that return for the whole, and loops without a bound
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    n_ = n_ + 1;
    d_ = d_ * 1.000001 + 3.0 / (n_ + 1);
    f_ = static_cast<float>(d_);
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile unsigned n_ = 0;
  volatile double d_ = 2;
  volatile float f_ = 1;
};
}  // namespace my
