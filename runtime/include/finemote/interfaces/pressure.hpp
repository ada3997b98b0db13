// A pressure sensor.
#pragma once

#include "finemote/contract.hpp"

namespace finemote {

struct PressureState : Stamp {
  float pressure = 0;     ///< Pa, absolute
  float temperature = 0;  ///< degrees Celsius
};

struct Pressure {
  using State = PressureState;
  using Command = void;
};

}  // namespace finemote
