// The I2C port of the board, as both drivers set it up.
#pragma once

#include "i2c_master.hpp"
#include "runtime/chips/cortex_m4/core.hpp"
#include "runtime/chips/stm32f4/peripherals.hpp"
#include "runtime/chips/stm32f4/pin.hpp"

namespace baseline {

constexpr finemote::stm32f4::I2cRegisters kI2c = finemote::stm32f4::kI2c2.i2c;
constexpr finemote::stm32f4::Pin kScl{'F', 1}, kSda{'F', 0};  ///< DS8626 table 9, function 4

/// Cycles in a time, cut off at 12 s.
constexpr std::uint32_t cycles_in(finemote::Duration time) {
  constexpr finemote::Duration kMost = 12 * finemote::kSecond;
  return static_cast<std::uint32_t>((time < kMost ? time : kMost) / finemote::kMicrosecond *
                                    (finemote::cortex_m4::kCoreHz / 1'000'000));
}

/// Clock, pins and timing; 400 kHz with a clock that is low twice as long as high. Reset before, which frees a
/// peripheral that has lost track of its bus. RM0090 27.6.
void set_up_i2c();

/// Clocks the bus by hand until whoever holds the data line lets go, nine clocks at most, then a STOP, and sets the
/// peripheral up anew. UM10204 3.1.16
void free_i2c();

}  // namespace baseline
