// A lamp that can be told a colour.
#pragma once

#include "finemote/contract.hpp"

namespace finemote {

struct LightState : Stamp {
  float red = 0, green = 0, blue = 0;  ///< what it shows, 0..1
};

struct LightCommand : Stamp {
  float red = 0, green = 0, blue = 0;  ///< 0..1; a lamp of one colour shows the brightest
};

struct Light {
  using State = LightState;
  using Command = LightCommand;
};

}  // namespace finemote
