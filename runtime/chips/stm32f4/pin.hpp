// One pin of the chip: from port letter and number to a configured input, output or alternate function.
#pragma once

#include <cstdint>

#include "runtime/chips/stm32f4/registers/gpio.hpp"

namespace finemote::stm32f4 {

struct Pin {
  char port;            ///< 'A'..'I'
  std::uint8_t number;  ///< 0..15

  [[nodiscard]] constexpr GpioRegisters registers() const { return gpio(port); }
  /// BSRR sets by the low half and resets by the high half, in one write (RM0090 8.4.7): safe from every priority.
  void set(bool high) const { registers().bsrr().write(bit(high ? number : number + 16U)); }
  [[nodiscard]] bool is_high() const { return registers().idr().any(bit(number)); }
};

/// MODER, RM0090 8.4.1.
enum class PinMode : std::uint8_t { input = 0, output = 1, alternate = 2, analog = 3 };
/// PUPDR, RM0090 8.4.4.
enum class PinPull : std::uint8_t { none = 0, up = 1, down = 2 };

struct PinSetup {
  PinMode mode = PinMode::input;
  PinPull pull = PinPull::none;
  bool open_drain = false;
  std::uint8_t function = 0;  ///< alternate function number, DS8626 table 9
};

/// An output that start-up sets to a level.
struct RestingPin {
  Pin pin;
  bool high;
};

/// Gives the port its clock and the pin its function. Start-up only: other pins of the port are read, then written
/// back.
void configure(Pin pin, const PinSetup& setup);

}  // namespace finemote::stm32f4
