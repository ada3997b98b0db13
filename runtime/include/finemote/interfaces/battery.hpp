// What a robot lives on.
#pragma once

#include "finemote/contract.hpp"

namespace finemote {

struct BatteryState : Stamp {
  float voltage = 0;   ///< V, smoothed
  bool low = false;    ///< below the voltage at which somebody should act
  bool empty = false;  ///< below the voltage at which it takes harm
};

struct Battery {
  using State = BatteryState;
  using Command = void;
};

}  // namespace finemote
