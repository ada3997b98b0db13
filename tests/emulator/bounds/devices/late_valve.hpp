#pragma once
#include <finemote/contract.hpp>
#include <finemote/i2c.hpp>
#include <finemote/interfaces/servo.hpp>

#include <cstdint>

namespace my {

/// handle() wakes the valve; update() sends what the job before was commanded.
class LateValve {
 public:
  constexpr explicit LateValve(finemote::I2cSlot& slot) : slot_(&slot) {}

  void update() {
    if (slot_->busy()) return;
    setting_[1] = next_;
    slot_->start(setting_, sizeof setting_);
  }
  void handle() {
    next_ = static_cast<std::uint8_t>(command.angle * kSteps);
    if (!slot_->busy()) slot_->start(&register_, 1);
  }
  void safe() {}

  finemote::ServoState state;
  finemote::ServoCommand command;

 private:
  static constexpr float kSteps = 100;  // per rad
  finemote::I2cSlot* slot_;
  std::uint8_t next_ = 0, setting_[2]{0x10, 0}, register_ = 0x20;
};

}  // namespace my
