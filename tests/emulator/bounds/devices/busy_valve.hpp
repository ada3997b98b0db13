#pragma once
#include <finemote/contract.hpp>
#include <finemote/i2c.hpp>
#include <finemote/interfaces/servo.hpp>

#include <cstdint>

namespace my {

/// A mistake: update() asks the valve, but for every tenth time, and handle() finds the slot busy.
class BusyValve {
 public:
  constexpr explicit BusyValve(finemote::I2cSlot& slot) : slot_(&slot) {}

  void update() {
    count_ = (count_ + 1) % 10;
    if (count_ != 0) slot_->start(&register_, 1, answer_, sizeof answer_);
  }
  void handle() {
    if (!slot_->busy()) setting_[1] = static_cast<std::uint8_t>(command.angle * kSteps);
    slot_->start(setting_, sizeof setting_);
  }
  void safe() {}

  finemote::ServoState state;
  finemote::ServoCommand command;

 private:
  static constexpr float kSteps = 100;  // per rad
  finemote::I2cSlot* slot_;
  std::uint8_t count_ = 0, setting_[2]{0x10, 0}, register_ = 0x20, answer_[2]{};
};

}  // namespace my
