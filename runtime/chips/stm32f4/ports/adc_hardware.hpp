// A converter of the chip, and the conversion under way.
#pragma once

#include <cstdint>

#include "finemote/ports.hpp"
#include "runtime/chips/stm32f4/peripherals.hpp"

namespace finemote {

struct AdcHardware {
  stm32f4::AdcPeripheral peripheral;
  bool converting = false;
  std::uint8_t input = 0;
};

}  // namespace finemote
