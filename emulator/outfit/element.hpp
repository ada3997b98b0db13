// A part or plant as a scenario knows it: by name, with things that can happen to it and values to look at.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "emulator/chip/i2c_line.hpp"
#include "emulator/chip/timer.hpp"
#include "emulator/outfit/entry.hpp"
#include "emulator/parts/serial_terminal.hpp"
#include "emulator/plants/motor_shaft.hpp"
#include "emulator/scenario/grammar.hpp"

namespace finemote::emulator {

class Outfit;

class Element {
 public:
  virtual ~Element() = default;
  /// Finds what it refers to, once all parts of its document exist.
  virtual void connect(Outfit& outfit) { static_cast<void>(outfit); }
  /// Makes `what` happen, with the members of `event`. @return false: that cannot happen to it
  bool happen(const std::string& what, const Json& event) const;
  /// A quantity by name; none: it has no such quantity.
  [[nodiscard]] std::optional<double> value(const std::string& quantity) const;
  /// Holds it to the table: everything it says of the model, and nothing else.
  /// @throws std::logic_error  naming the action or value that only one of them has
  void check_complete(const scenario::Model& model) const;

 protected:
  using Handler = std::function<void(const Json& event)>;
  using Look = std::function<double()>;
  /// What a verb of its model does. The event was checked.
  void on(const std::string& verb, Handler handler) { handlers_[verb] = std::move(handler); }
  /// Where a quantity of its model comes from; it may be looked at at any time.
  void show(const std::string& quantity, Look look) { looks_[quantity] = std::move(look); }

 private:
  std::map<std::string, Handler> handlers_;
  std::map<std::string, Look> looks_;
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

using MakeElement = std::unique_ptr<Element> (*)(Outfit& outfit, const Json& part, const std::string& name);

// One file each.
std::unique_ptr<Element> make_h30(Outfit& outfit, const Json& part, const std::string& name);
std::unique_ptr<Element> make_host_terminal(Outfit& outfit, const Json& part, const std::string& name);
std::unique_ptr<Element> make_dbus_receiver(Outfit& outfit, const Json& part, const std::string& name);
std::unique_ptr<Element> make_sbus_receiver(Outfit& outfit, const Json& part, const std::string& name);
std::unique_ptr<Element> make_tca9548a(Outfit& outfit, const Json& part, const std::string& name);
std::unique_ptr<Element> make_ms5837(Outfit& outfit, const Json& part, const std::string& name);
std::unique_ptr<Element> make_ist8310(Outfit& outfit, const Json& part, const std::string& name);
std::unique_ptr<Element> make_register_bank(Outfit& outfit, const Json& part, const std::string& name);
std::unique_ptr<Element> make_pca9685(Outfit& outfit, const Json& part, const std::string& name);
std::unique_ptr<Element> make_pwm_output(Outfit& outfit, const Json& part, const std::string& name);
std::unique_ptr<Element> make_thruster(Outfit& outfit, const Json& part, const std::string& name);
std::unique_ptr<Element> make_bmi088(Outfit& outfit, const Json& part, const std::string& name);
std::unique_ptr<Element> make_dji_motor(Outfit& outfit, const Json& part, const std::string& name);
std::unique_ptr<Element> make_standing_body(Outfit& outfit, const Json& part, const std::string& name);
std::unique_ptr<Element> make_submerged_body(Outfit& outfit, const Json& part, const std::string& name);
std::unique_ptr<Element> make_mecanum_base(Outfit& outfit, const Json& part, const std::string& name);
std::unique_ptr<Element> make_weights(Outfit& outfit, const Json& part, const std::string& name);

}  // namespace finemote::emulator
