// Counts the edges of three lines, and shows the lowest bit of the third count at a pin.
#pragma once

#include <finemote/contract.hpp>
#include <finemote/gpio.hpp>

/// Read by the test: counts, then the time of the third line's last edge [ns, low word]; edges of a use nobody gave.
extern "C" {
inline std::uint32_t edges_seen[5]{};
}

namespace testing {

class EdgeWatch {
 public:
  constexpr EdgeWatch(finemote::EdgePin first, finemote::EdgePin second, finemote::EdgePin* third,
                      finemote::EdgePin* absent, finemote::GpioPin* lamp)
      : first_(first), second_(second), third_(third), absent_(absent), lamp_(lamp) {}

  void update() {
    edges_seen[0] = first_.last().count;
    edges_seen[1] = second_.last().count;
    const finemote::Edge third = third_->last();
    edges_seen[2] = third.count;
    edges_seen[3] = static_cast<std::uint32_t>(third.at);
    edges_seen[4] = absent_ != nullptr ? 1 : 0;
    lamp_->activate(third.count % 2 != 0);
    state.origin = finemote::now();
    state.valid = true;
  }
  void handle() {}

  finemote::Stamp state;

 private:
  finemote::EdgePin first_, second_;
  finemote::EdgePin* third_;
  finemote::EdgePin* absent_;
  finemote::GpioPin* lamp_;
};

}  // namespace testing
