// A serial port of the board by polling.
#pragma once

#include <cstdint>

#include "bench_plan.hpp"

namespace finemote::bench_kit {

/// Pins, clock and rate, 8N1, of a port that may have been used before.
/// @param bus_hz    what the port's rate is divided from, now
/// @param parts_on  receiver, transmitter or both: bits of CR1
void start_uart(const UartPins& port, std::uint32_t bus_hz, std::uint32_t parts_on);

}  // namespace finemote::bench_kit
