#pragma once
#include <finemote/contract.hpp>
#include <finemote/i2c.hpp>
#include <finemote/interfaces/servo.hpp>

#include "range.hpp"

namespace my {

/// A motor driver with its encoder below it. Its handle() forgets to send.
class Drive {
 public:
  constexpr Drive(finemote::I2cSlot& slot, finemote::Port<Distance> encoder) : slot_(&slot), encoder_(encoder) {}
  void update() { state = {encoder_.state.origin, encoder_.state.valid}; }
  void handle() {}
  void safe() {}

  finemote::ServoState state;
  finemote::ServoCommand command;

 private:
  finemote::I2cSlot* slot_;
  finemote::Port<Distance> encoder_;
};

}  // namespace my
