// One external interrupt line of the chip: its pin, and the edges it has seen.
#pragma once

#include <cstdint>

#include "finemote/ports.hpp"
#include "finemote/single_core.hpp"
#include "runtime/chips/stm32f4/pin.hpp"

namespace finemote {

struct EdgeHardware {
  stm32f4::Pin pin;   ///< its number is that of the EXTI line
  std::uint8_t line;  ///< of the interrupt controller
  Shared<std::uint32_t> count{0};
  Time at = 0;

  /// The line has seen an edge: asked where several lines share an interrupt.
  [[nodiscard]] bool is_pending() const;
  /// The interrupt routine's work: note the edge, clear the flag.
  void on_interrupt();
};

}  // namespace finemote
