// A serial port of the board by polling.
#pragma once

#include <cstdint>

#include "bench_plan.hpp"

namespace finemote::bench_kit {

/// Pins, clock and rate, 8N1. @param parts_on  receiver, transmitter or both: bits of CR1
void start_uart(const UartPins& port, std::uint32_t parts_on);

}  // namespace finemote::bench_kit
