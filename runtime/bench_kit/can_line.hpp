// A CAN controller by polling: its way into initialisation, and frames that it sends to itself.
#pragma once

#include <cstdint>

#include "runtime/chips/stm32f4/peripherals.hpp"

namespace finemote::bench_kit {

struct CanStart {
  bool came = false;  ///< within 50 ms
  std::uint32_t cycles = 0;
};

/// Resets CAN1, wakes it and asks it to initialise: RM0090 32.4.1. It takes no part in the bus.
CanStart enter_initialisation();

struct CanLoop {
  bool came = false;         ///< all were sent
  std::uint32_t cycles = 0;  ///< from the end of one to the end of the next
  std::uint32_t wrong = 0;   ///< that did not come back as they were sent
};

/// CAN1 sends three frames to itself at 1 Mbit/s, in loop-back and silent mode: RM0090 32.5.3. The bus neither hears
/// nor disturbs them.
CanLoop send_to_itself();

/// Leads what a controller sends to itself, and to nobody else, from now on; it may be in use.
/// @return false: it does not let itself be initialised
bool turn_inward(const stm32f4::CanPeripheral& it);

/// Sends a frame of eight zeros where a mailbox is free.
void send_frame(const stm32f4::CanPeripheral& it, std::uint32_t identifier);

}  // namespace finemote::bench_kit
