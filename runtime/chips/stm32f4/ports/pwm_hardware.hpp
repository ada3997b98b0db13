// One PWM output of the chip: a channel of a timer and its pin.
#pragma once

#include <cstdint>

#include "finemote/ports.hpp"
#include "runtime/chips/stm32f4/peripherals.hpp"
#include "runtime/chips/stm32f4/pin.hpp"

namespace finemote {
namespace stm32f4 {

/// Facts of one port; in flash.
struct PwmSetup : TimerPeripheral {
  std::uint32_t channel;  ///< 1..4
  Pin pin;
  std::uint8_t function;
};

}  // namespace stm32f4

struct PwmHardware {
  const stm32f4::PwmSetup& setup;
  std::uint32_t scale = 0;  ///< timer counts per ns, times 2^32
  std::uint32_t top = 0;    ///< counts of one repetition
};

}  // namespace finemote
