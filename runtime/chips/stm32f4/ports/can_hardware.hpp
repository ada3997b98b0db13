// A CAN controller of the chip: its registers, pins, filter banks and lines.
#pragma once

#include <cstdint>

#include "finemote/at_start.hpp"
#include "finemote/ports.hpp"
#include "runtime/chips/stm32f4/peripherals.hpp"
#include "runtime/chips/stm32f4/pin.hpp"

namespace finemote {
namespace stm32f4 {

/// Facts of one port; in flash.
struct CanSetup : CanPeripheral {
  Pin rx, tx;
  std::uint8_t alternate_function;
  std::uint8_t first_bank;
  std::uint8_t transmit_line, receive_line, error_line;
};

}  // namespace stm32f4

struct CanHardware {
  const stm32f4::CanSetup& setup;
  AtStart<CanBus*> bus{};

  /// The routines of its lines. Context: interrupt.
  void on_transmit();
  void on_receive();
  void on_error();
};

}  // namespace finemote
