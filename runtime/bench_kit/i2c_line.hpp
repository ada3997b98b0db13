// The I2C of the board's magnetometer as master, by polling. Procedures: RM0090 27.3.3.
#pragma once

#include <cstdint>

namespace finemote::bench_kit {

/// At 400 kHz.
void start_i2c();

/// A register of a part, read as a single byte: STOP has to be asked for right behind the address.
struct Reading {
  bool came = false;  ///< acknowledged, and in time
  std::uint8_t byte = 0;
  bool is_late = false;           ///< the byte was there before the STOP was asked for
  std::uint32_t stop_cycles = 0;  ///< from the byte to the end of the STOP
};
enum class Interrupts : std::uint8_t { masked, allowed };
/// @param interrupts  between address and STOP
Reading read_register(std::uint8_t part, std::uint8_t address, Interrupts interrupts);

/// Reads so many bytes from a register on.
/// @return from the first to the last [cycles]; 0: they did not come
std::uint32_t time_bytes(std::uint8_t part, std::uint8_t address, unsigned count);

}  // namespace finemote::bench_kit
