#pragma once
#include <finemote/contract.hpp>
#include <finemote/i2c.hpp>

#include <cstdint>

namespace my {

struct DistanceState : finemote::Stamp {
  std::uint8_t distance = 0;
};
struct Distance {
  using State = DistanceState;
  using Command = void;
};

/// Keeps its last distance where the part says 255.
class Range {
 public:
  constexpr explicit Range(finemote::I2cSlot& slot) : slot_(&slot) {}
  void update() {
    if (slot_->busy()) return;
    if (slot_->done() && answer_ != 255) {
      state.distance = answer_;
      state.origin = asked_;
      state.valid = true;
    }
    asked_ = finemote::now();
    slot_->start(&register_, 1, &answer_, 1);
  }
  void handle() {}

  DistanceState state;

 private:
  finemote::I2cSlot* slot_;
  finemote::Time asked_ = 0;
  std::uint8_t register_ = 81, answer_ = 255;
};

}  // namespace my
