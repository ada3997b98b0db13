// A magnetic compass.
#pragma once

#include "finemote/contract.hpp"

namespace finemote {

/// What it measures.
struct MagnetometerState : Stamp {
  float field[3] = {};  ///< T along x, y, z
};

/// Offered by compasses; nothing to command.
struct Magnetometer {
  using State = MagnetometerState;
  using Command = void;
};

}  // namespace finemote
