// A rotating motor with feedback.
#pragma once

#include "finemote/contract.hpp"

namespace finemote {

/// What it tells of itself.
struct MotorState : Stamp {
  float angle = 0;           ///< rad at the output shaft, continuous
  float speed = 0;           ///< rad/s at the output shaft
  float torque = 0;          ///< N m at the output shaft
  float temperature = 0;     ///< degrees Celsius; 0 where the motor does not tell it
  bool unreachable = false;  ///< its bus fails: what it does is unknown
};

/// What it should do.
struct MotorCommand : Stamp {
  float torque = 0;  ///< N m at the output shaft
};

/// Offered by motors that are commanded by torque.
struct Motor {
  using State = MotorState;
  using Command = MotorCommand;
};

}  // namespace finemote
