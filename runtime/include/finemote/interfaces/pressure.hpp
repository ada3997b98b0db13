// A pressure sensor.
#pragma once

#include "finemote/contract.hpp"

namespace finemote {

/// What it measures.
struct PressureState : Stamp {
  float pressure = 0;     ///< Pa, absolute
  float temperature = 0;  ///< degrees Celsius
};

/// Offered by pressure sensors; nothing to command.
struct Pressure {
  using State = PressureState;
  using Command = void;
};

}  // namespace finemote
