// An inertial sensor with attitude.
#pragma once

#include "finemote/contract.hpp"

namespace finemote {

/// Frame: x forward, y left, z up, right-handed; angles turn positive about the axis.
struct ImuState : Stamp {
  float roll = 0;              ///< rad, [-pi, pi]
  float pitch = 0;             ///< rad, [-pi/2, pi/2]
  float yaw = 0;               ///< rad, [-pi, pi]
  float rate[3] = {};          ///< rad/s about x, y, z
  float acceleration[3] = {};  ///< m/s^2 along x, y, z; at rest and level z reads +9.81
};

/// Offered by inertial sensors; nothing to command.
struct Imu {
  using State = ImuState;
  using Command = void;
};

}  // namespace finemote
