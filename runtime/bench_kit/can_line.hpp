// The way of a CAN controller into its initialisation.
#pragma once

#include <cstdint>

namespace finemote::bench_kit {

struct CanStart {
  bool came = false;  ///< within 50 ms
  std::uint32_t cycles = 0;
};

/// Resets CAN1, wakes it and asks it to initialise: RM0090 32.4.1. It takes no part in the bus.
CanStart enter_initialisation();

}  // namespace finemote::bench_kit
