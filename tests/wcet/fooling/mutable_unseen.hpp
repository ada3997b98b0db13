// refused: a mutable member that is changed through a pointer of which nothing is known
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace my {
struct Count {
  mutable std::uint32_t rounds = 5;
};
class Walker {
 public:
  void update() {
    where()->set(200);
    for (std::uint32_t i = 0; i < count_.rounds; ++i) x_ = x_ * 5 / 3;
  }
  void handle() {}
  finemote::Stamp state;

 private:
  void set(std::uint32_t rounds) const { count_.rounds = rounds; }
  [[gnu::noipa]] Walker* where() {
    self_ = this;
    return self_;
  }

  volatile std::uint32_t x_ = 3;
  Walker* volatile self_ = nullptr;
  const Count count_{};
};
}  // namespace my
