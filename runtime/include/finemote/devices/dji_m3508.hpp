// DJI M3508 motor with its C620 speed controller.
#pragma once

#include "finemote/devices/dji_motor.hpp"

namespace finemote {

/// See DjiMotor. Ids 1..4 share command frame 0x200, ids 5..8 frame 0x1FF; feedback is 0x200 + id.
class DjiM3508 : public DjiMotor {
 public:
  struct Config {
    float gear = 3591.0F / 187;             ///< turns of the rotor per turn of the output shaft
    Duration max_age = 100 * kMillisecond;  ///< of the command's origin
  };
  constexpr DjiM3508(const Config& config, CanSlot& slot)
      : DjiMotor(detail::kC620, config.gear, config.max_age, slot) {}
};

}  // namespace finemote
