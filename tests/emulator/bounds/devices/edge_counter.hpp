// Counts the edges of a line that interrupts.
#pragma once

#include <finemote/contract.hpp>
#include <finemote/gpio.hpp>

namespace testing {

class EdgeCounter {
 public:
  constexpr explicit EdgeCounter(finemote::EdgePin line) : line_(line) {}

  void update() {
    count_ = line_.last().count;
    state = {finemote::now(), true};
  }
  void handle() {}

  finemote::Stamp state;

 private:
  const finemote::EdgePin line_;
  std::uint32_t count_ = 0;
};

}  // namespace testing
