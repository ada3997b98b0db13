// A thruster: a propeller with its speed controller.
#pragma once

#include "finemote/contract.hpp"

namespace finemote {

/// What it can know.
struct ThrusterState : Stamp {
  bool unreachable = false;  ///< its bus fails: the output is unknown
  float effort = 0;          ///< what is driven now, -1..1
};

/// How hard it should push.
struct ThrusterCommand : Stamp {
  float effort = 0;  ///< fraction of full drive, -1..1; positive pushes along the thruster's axis
};

/// Offered by speed controllers of propellers.
struct Thruster {
  using State = ThrusterState;
  using Command = ThrusterCommand;
};

}  // namespace finemote
