#pragma once
#include <finemote/contract.hpp>
#include <finemote/i2c.hpp>
#include <finemote/interfaces/servo.hpp>
#include <finemote/time.hpp>

#include <cstdint>

namespace my {

/// A full exchange in update(): the angle of the last job goes out, and what the servo says comes back.
class AskedServo {
 public:
  constexpr explicit AskedServo(finemote::I2cSlot& slot) : slot_(&slot) {}

  void update() {
    if (slot_->busy()) return;
    if (slot_->done()) state = {asked_, true};
    asked_ = finemote::now();
    question_[1] = next_;
    slot_->start(question_, sizeof question_, answer_, sizeof answer_);
  }
  void handle() { next_ = static_cast<std::uint8_t>(command.angle * kSteps); }
  void safe() {}

  finemote::ServoState state;
  finemote::ServoCommand command;

 private:
  static constexpr float kSteps = 100;  // per rad
  finemote::I2cSlot* slot_;
  finemote::Time asked_ = 0;
  std::uint8_t next_ = 0, question_[2]{0x10, 0}, answer_[2]{};
};

}  // namespace my
