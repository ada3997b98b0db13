// A lamp that can be told a colour.
#pragma once

#include "finemote/contract.hpp"

namespace finemote {

/// What it shows.
struct LightState : Stamp {
  float red = 0;    ///< 0..1
  float green = 0;  ///< 0..1
  float blue = 0;   ///< 0..1
};

/// What it should show.
struct LightCommand : Stamp {
  float red = 0;    ///< 0..1; a lamp of one colour shows the brightest of the three
  float green = 0;  ///< 0..1
  float blue = 0;   ///< 0..1
};

/// Offered by lamps.
struct Light {
  using State = LightState;
  using Command = LightCommand;
};

}  // namespace finemote
