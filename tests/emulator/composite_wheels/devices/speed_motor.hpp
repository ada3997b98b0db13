// A motor behind a composite, as users write them around a loop of their own.
#pragma once

#include "finemote/contract.hpp"
#include "finemote/interfaces/motor.hpp"

class SpeedMotor {
 public:
  constexpr explicit SpeedMotor(finemote::Port<finemote::Motor> motor) : motor_(motor) {}

  void update() { state = motor_.state; }
  void handle() { motor_.command = command; }

  finemote::MotorState state;
  finemote::MotorCommand command;

 private:
  finemote::Port<finemote::Motor> motor_;
};
