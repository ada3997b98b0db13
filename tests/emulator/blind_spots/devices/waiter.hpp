#pragma once
#include <finemote/contract.hpp>

namespace my {

/// Waits for a flag that does not come in its second job.
class Waiter {
 public:
  constexpr Waiter() = default;
  void update() {
    ++count_;
    while (count_ > 1) asm volatile("" ::: "memory");
    state = {finemote::now(), true};
  }
  void handle() {}

  finemote::Stamp state;

 private:
  unsigned count_ = 0;
};

}  // namespace my
