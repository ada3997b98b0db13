// A CAN controller of the chip: its registers, pins, filter banks and lines.
#pragma once

#include <cstdint>

#include "finemote/ports.hpp"
#include "runtime/boards/robomaster_type_c/pin.hpp"
#include "runtime/boards/robomaster_type_c/registers/can.hpp"

namespace finemote {
namespace robomaster_type_c {

/// Facts of one port; in flash.
struct CanSetup {
  stm32f407::CanRegisters can;
  std::uint32_t clock_bits;  ///< in rcc::apb1enr; CAN2 needs CAN1's too, which holds the filters (RM0090 32.3.5)
  Pin rx, tx;
  std::uint8_t first_bank;
  std::uint8_t transmit_line, receive_line, error_line;
};

}  // namespace robomaster_type_c

struct CanHardware {
  const robomaster_type_c::CanSetup& setup;
  CanBus* bus = nullptr;

  /// The routine of all its lines. Context: interrupt.
  void on_line();
};

}  // namespace finemote
