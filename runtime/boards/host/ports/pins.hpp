// The pulse outputs and single pins of the host board, as a recorder sees them.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "finemote/ports.hpp"

namespace finemote {

struct PwmHardware {
  struct Write {
    Time at;
    std::uint32_t pulse;  ///< ns
  };
  Duration period = 0;  ///< 0: not started
  std::vector<Write> writes;
};

struct GpioHardware {
  std::map<std::uint8_t, bool> levels;  ///< outputs as written, inputs as the test set them; absent: low
};

}  // namespace finemote

namespace finemote::host {
extern PwmHardware pwm1, pwm2, pwm3, pwm4, pwm5, pwm6, pwm7;
extern GpioHardware gpio;
}  // namespace finemote::host
