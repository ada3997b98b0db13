// Turns the number of a chip pin into a level that can be read and set.
#pragma once

#include <cstdint>

#include "finemote/ports.hpp"

namespace finemote {

/// The chip's single pins as a bus: `<bus type="gpio">`. The pins in use are configured by name in start_buses().
class GpioBus {
 public:
  /// All pins of the chip.
  constexpr explicit GpioBus(GpioPort& port) : port_(&port) {}

  /// Nothing to do: the pins are configured one by one. Context: init.
  void start() {}
  /// Sets the level of an output. Context: any. `pin`: see pin_number().
  void write(std::uint8_t pin, bool high) { port_->write(pin, high); }
  /// The level of a pin. Context: any.
  [[nodiscard]] bool read(std::uint8_t pin) const { return port_->read(pin); }

 private:
  GpioPort* const port_;
};

/// One pin, as a device holds it. Active is what the board file says: low for a key to ground, high for a lamp.
class GpioPin {
 public:
  /// @param port        the board's
  /// @param pin         see pin_number()
  /// @param active_low  what the board file says of the pin
  constexpr GpioPin(GpioPort& port, std::uint8_t pin, bool active_low = false)
      : port_(&port), pin_(pin), active_low_(active_low) {}

  /// Sets the level of an output. Context: any.
  void write(bool high) { port_->write(pin_, high); }
  /// The level on the pin. Context: any.
  [[nodiscard]] bool read() const { return port_->read(pin_); }
  /// Sets an output to what means on or off. Context: any.
  void activate(bool on) { write(on != active_low_); }
  /// Whether the level means on. Context: any.
  [[nodiscard]] bool active() const { return read() != active_low_; }

 private:
  GpioPort* port_;
  const std::uint8_t pin_;
  const bool active_low_;
};

/// One pin whose edges into the active level are timed, as a device holds it.
class EdgePin {
 public:
  /// The pin of this port.
  constexpr explicit EdgePin(EdgePort& port) : port_(&port) {}

  /// The last edge into the active level. Context: bucket.
  [[nodiscard]] Edge last() const { return port_->last(); }

 private:
  EdgePort* port_;
};

}  // namespace finemote
