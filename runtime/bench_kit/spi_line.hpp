// An SPI of the board as master, by polling.
#pragma once

#include <cstdint>

#include "bench_plan.hpp"

namespace finemote::bench_kit {

/// Clock of every exchange: of the port's bus, divided by 2 << kDivider.
inline constexpr std::uint32_t kSpiDivider = 3;

/// Pins and clock; leaves the peripheral off.
void start_spi(const SpiPins& port);

/// The control word of an SPI that is on, in mode 3. @param divider  its clock is that of its bus by 2 << divider
std::uint32_t spi_control(std::uint32_t divider);

/// Sends the bytes and puts what comes in their place, with the chip select down meanwhile.
/// @return false: a byte did not come in time
bool exchange(const SpiPins& port, unsigned select, std::uint8_t* bytes, unsigned size);

}  // namespace finemote::bench_kit
