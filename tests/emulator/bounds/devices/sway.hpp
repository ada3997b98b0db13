#pragma once
#include <finemote/contract.hpp>
#include <finemote/interfaces/servo.hpp>
#include <finemote/time.hpp>

namespace my {

/// Moves its servos up and down in steps, so that every command differs from the one before.
class Sway {
 public:
  constexpr explicit Sway(finemote::Ports<finemote::Servo> servos) : servos_(servos) {}

  void update() {
    state.origin = finemote::now();
    state.valid = true;
  }

  void handle() {
    step_ = (step_ + 1) % kSteps;
    for (const auto& servo : servos_) {
      servo.command.angle = static_cast<float>(step_) * kStep;
      servo.command.origin = state.origin;
      servo.command.valid = true;
    }
  }

  finemote::Stamp state;

 private:
  static constexpr int kSteps = 48;
  static constexpr float kStep = 0.025F;  // rad
  finemote::Ports<finemote::Servo> servos_;
  int step_ = 0;
};

}  // namespace my
