#pragma once
#include <finemote/contract.hpp>
#include <finemote/i2c.hpp>
#include <finemote/interfaces/pressure.hpp>

#include <cstdint>

namespace my {

/// Shows what its sensor says on a part of its own. Nobody commands it.
class Display {
 public:
  constexpr Display(finemote::I2cSlot& slot, finemote::Port<finemote::Pressure> depth) : slot_(&slot), depth_(depth) {}

  void update() { state = depth_.state; }
  void handle() {
    if (slot_->busy()) return;
    ++shown_[1];
    slot_->start(shown_, sizeof shown_);
  }
  void safe() {}

  finemote::Stamp state;

 private:
  finemote::I2cSlot* slot_;
  const finemote::Port<finemote::Pressure> depth_;
  std::uint8_t shown_[2]{0x20, 0};
};

}  // namespace my
