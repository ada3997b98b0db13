// One external interrupt line of the chip: its pin, and the edges it has seen.
#pragma once

#include <cstdint>

#include "finemote/ports.hpp"
#include "finemote/single_core.hpp"
#include "runtime/boards/robomaster_type_c/pin.hpp"

namespace finemote {

struct EdgeHardware {
  robomaster_type_c::Pin pin;  ///< its number is that of the EXTI line
  std::uint8_t line;           ///< of the interrupt controller
  Shared<std::uint32_t> count{0};
  Time at = 0;

  /// The interrupt routine's work: note the edge, clear the flag.
  void on_interrupt();
};

}  // namespace finemote
