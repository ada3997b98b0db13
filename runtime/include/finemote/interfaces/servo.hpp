// A servo: it goes to an angle and does not say where it is.
#pragma once

#include "finemote/contract.hpp"

namespace finemote {

/// What it can know.
struct ServoState : Stamp {
  float angle = 0;           ///< rad, what is asked of it now
  bool unreachable = false;  ///< its bus fails: the output is unknown
};

/// Where it should go.
struct ServoCommand : Stamp {
  float angle = 0;  ///< rad, 0 at the neutral pulse
};

/// Offered by servos.
struct Servo {
  using State = ServoState;
  using Command = ServoCommand;
};

}  // namespace finemote
