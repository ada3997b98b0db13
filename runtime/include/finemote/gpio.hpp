// Turns the number of a chip pin into a level that can be read and set.
#pragma once

#include <cstdint>

#include "finemote/ports.hpp"

namespace finemote {

/// The chip's single pins as a bus: `<bus type="gpio">`. The pins in use are configured by name in start_buses().
class GpioBus {
 public:
  constexpr explicit GpioBus(GpioPort& port) : port_(&port) {}

  /// Context: init.
  void start() {}
  /// Context: any. `pin`: see pin_number().
  void write(std::uint8_t pin, bool high) { port_->write(pin, high); }
  [[nodiscard]] bool read(std::uint8_t pin) const { return port_->read(pin); }

 private:
  GpioPort* port_;
};

/// One pin, as a device holds it. Active is what the board file says: low for a key to ground, high for a lamp.
class GpioPin {
 public:
  constexpr GpioPin(GpioPort& port, std::uint8_t pin, bool active_low = false)
      : port_(&port), pin_(pin), active_low_(active_low) {}

  /// The level on the pin. Context: any.
  void write(bool high) { port_->write(pin_, high); }
  [[nodiscard]] bool read() const { return port_->read(pin_); }
  /// What the level means. Context: any.
  void activate(bool on) { write(on != active_low_); }
  [[nodiscard]] bool active() const { return read() != active_low_; }

 private:
  GpioPort* port_;
  std::uint8_t pin_;
  bool active_low_;
};

/// One pin whose edges into the active level are timed, as a device holds it.
class EdgePin {
 public:
  constexpr explicit EdgePin(EdgePort& port) : port_(&port) {}

  [[nodiscard]] Edge last() const { return port_->last(); }

 private:
  EdgePort* port_;
};

}  // namespace finemote
