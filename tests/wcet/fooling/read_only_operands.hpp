// bounded: a counter that divisions only read stays one
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {
class Walker {
 public:
  void update() {
    for (int i = 0; i < 12; ++i) out_ = total_ / (i + 1);
    for (int i = 0; i < 8; ++i) out_ = out_ + total_ % (i + 2);
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile int total_ = 7, out_ = 0;
};
}  // namespace my
