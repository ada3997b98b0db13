// refused: a function of the library that is aligned to more than what surrounds it
#pragma once

#include <cstdint>
#include <cstring>

#include "finemote/contract.hpp"

namespace my {

struct Walker {
  void update() { n_ = static_cast<std::uint32_t>(std::strlen(text_)); }
  void handle() {}
  finemote::Stamp state;

 private:
  volatile std::uint32_t n_ = 0;
  char text_[40] = {};
};
}  // namespace my
