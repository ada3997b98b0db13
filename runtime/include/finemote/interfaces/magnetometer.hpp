// A magnetic compass.
#pragma once

#include "finemote/contract.hpp"

namespace finemote {

struct MagnetometerState : Stamp {
  float field[3] = {};  ///< T along x, y, z
};

struct Magnetometer {
  using State = MagnetometerState;
  using Command = void;
};

}  // namespace finemote
