// One PWM output of the chip: a channel of a timer and its pin.
#pragma once

#include <cstdint>

#include "finemote/ports.hpp"
#include "runtime/boards/robomaster_type_c/pin.hpp"
#include "runtime/boards/robomaster_type_c/registers/timer.hpp"

namespace finemote {
namespace robomaster_type_c {

/// Facts of one port; in flash.
struct PwmSetup {
  stm32f407::TimerRegisters timer;
  std::uint32_t clock_bit;  ///< in rcc::apb2enr, or apb1enr
  std::uint32_t channel;    ///< 1..4
  Pin pin;
  std::uint8_t function;
  bool on_apb1 = false;  ///< TIM2 to TIM7: half the clock
};

}  // namespace robomaster_type_c

struct PwmHardware {
  const robomaster_type_c::PwmSetup& setup;
  std::uint32_t scale = 0;  ///< timer counts per ns, times 2^32
  std::uint32_t top = 0;    ///< counts of one repetition
};

}  // namespace finemote
