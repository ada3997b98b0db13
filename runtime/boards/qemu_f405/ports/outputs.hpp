// Pulses, pins, edges and voltages that nobody sees or makes.
#pragma once

#include "finemote/ports.hpp"

namespace finemote {

struct PwmHardware {
  std::uint32_t pulse = 0;
};

struct GpioHardware {
  std::uint32_t levels[8]{};
};

struct EdgeHardware {};
struct AdcHardware {};

}  // namespace finemote
