// DJI GM6020 gimbal motor in current mode.
#pragma once

#include "finemote/devices/dji_motor.hpp"

namespace finemote {

/// See DjiMotor. Direct drive, commanded by current: needs the motor's firmware with current mode, switched on in it.
/// Ids 1..4 share command frame 0x1FE, ids 5..7 frame 0x2FE; feedback is 0x204 + id, so that id n and a C6x0 with id n
/// + 4 exclude each other on one bus.
class DjiGm6020 : public DjiMotor {
 public:
  struct Config {
    float zero = 0;                         ///< rad, what the encoder reads where the joint is at zero; -7..7
    Duration max_age = 100 * kMillisecond;  ///< of the command's origin
  };
  constexpr DjiGm6020(const Config& config, CanSlot& slot)
      : DjiMotor(detail::kGm6020, 1, config.max_age, slot, config.zero) {}
};

}  // namespace finemote
