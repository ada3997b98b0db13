// What a robot lives on.
#pragma once

#include "finemote/contract.hpp"

namespace finemote {

/// What it says.
struct BatteryState : Stamp {
  float voltage = 0;   ///< V, smoothed
  bool low = false;    ///< below the voltage at which somebody should act
  bool empty = false;  ///< below the voltage at which it takes harm
};

/// Offered by what measures the supply; nothing to command.
struct Battery {
  using State = BatteryState;
  using Command = void;
};

}  // namespace finemote
