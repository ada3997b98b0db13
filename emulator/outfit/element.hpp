// A part or plant on the board, by the name a scenario gives it. What can happen to it and be looked at stands in its
// row: a function of its file.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "emulator/chip/i2c_line.hpp"
#include "emulator/chip/timer.hpp"
#include "emulator/outfit/entry.hpp"
#include "emulator/parts/ready_output.hpp"
#include "emulator/parts/serial_terminal.hpp"
#include "emulator/plants/motor_shaft.hpp"

namespace finemote::emulator {

class Outfit;

class Element {
 public:
  Element(Outfit& outfit, std::string name) : outfit_(outfit), name_(std::move(name)) {}
  virtual ~Element() = default;
  Element(const Element&) = delete;
  Element& operator=(const Element&) = delete;
  /// Finds what it refers to, once all parts of its document exist.
  virtual void connect() {}

 protected:
  Outfit& outfit() { return outfit_; }
  [[nodiscard]] Time now() const;
  /// Of the board, for a part that acts by itself.
  [[nodiscard]] PartClock part_clock() const;
  /// It sampled a quantity at `from`, and its last bit can be read at `until`. @return what its bytes carry
  Tag record_sample(Time from, Time until);
  /// The same in two steps: bytes that carry it leave, and, later, its last bit can be read now.
  Tag begin_sample(unsigned channel, Time from);
  void end_sample(unsigned channel, Tag sample);
  /// An output took this value now: pulse width [ns], current command. @param origin  of the bytes that said so
  void record_output(unsigned channel, double value, Tag origin);

 private:
  Outfit& outfit_;
  std::string name_;
};

// What elements can be to others.

class LineSource {  ///< provides I2C buses
 public:
  virtual ~LineSource() = default;
  virtual I2cLine* line(unsigned channel) = 0;
};

class PulseSource {  ///< provides PWM outputs
 public:
  using Listener = std::function<void(Timer::Pulse pulse)>;
  virtual ~PulseSource() = default;
  virtual bool listen(unsigned channel, Listener listener) = 0;
};

class BodySource {
 public:
  virtual ~BodySource() = default;
  virtual Body& body() = 0;
};

class ShaftSource {
 public:
  virtual ~ShaftSource() = default;
  virtual MotorShaft& shaft() = 0;
};

class Hearing {  ///< remembers bytes
 public:
  virtual ~Hearing() = default;
  virtual SerialTerminal& terminal() = 0;
};

}  // namespace finemote::emulator
