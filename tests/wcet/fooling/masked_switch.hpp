// bounded: a switch over three bits, whose table the compiler addresses by ADDW
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() {
    const std::uint32_t v = x_;
    switch (v & 7) {
      case 1:
        x_ = v * 5;
        break;
      case 2:
        y_ = v / 3;
        break;
      case 3:
        x_ = y_ + 7;
        break;
      case 4:
        y_ = v * 8;
        break;
      case 5:
        x_ = v ^ y_;
        break;
      case 6:
        y_ = y_ * v;
        break;
      default:
        break;
    }
    x_ = x_ + 1;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t x_ = 3, y_ = 0;
};
}  // namespace my
