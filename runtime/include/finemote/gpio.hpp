// Turns a pin number of the board file into a level that can be read and set.
#pragma once

#include <cstdint>

#include "finemote/ports.hpp"

namespace finemote {

/// The board's single pins as a bus.
class GpioBus {
 public:
  constexpr explicit GpioBus(GpioPort& port) : port_(&port) {}

  /// Context: init.
  void start() { port_->start(); }
  /// Context: any.
  void write(std::uint8_t pin, bool high) { port_->write(pin, high); }
  [[nodiscard]] bool read(std::uint8_t pin) const { return port_->read(pin); }

 private:
  GpioPort* port_;
};

/// One pin, as a device holds it.
class GpioPin {
 public:
  constexpr GpioPin(GpioBus& bus, std::uint8_t pin) : bus_(&bus), pin_(pin) {}

  void write(bool high) { bus_->write(pin_, high); }
  [[nodiscard]] bool read() const { return bus_->read(pin_); }

 private:
  GpioBus* bus_;
  std::uint8_t pin_;
};

}  // namespace finemote
