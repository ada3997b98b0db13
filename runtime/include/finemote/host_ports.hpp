// What hangs on the host board's ports: models of parts, recorded bytes, and what the robot drove.
//
// Nothing attached: an I2C bus on which nobody answers, a serial line on which nothing arrives, outputs nobody looks
// at.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "finemote/ports.hpp"
#include "finemote/time.hpp"

namespace finemote::host {

/// How the parts of an I2C bus react to one exchange.
enum class I2cAnswer : std::uint8_t {
  kDone,   ///< acknowledged; the bytes asked for are in `message.read`
  kNack,   ///< nobody there
  kError,  ///< bus error or arbitration lost
  kNever,  ///< clock held low: the exchange does not end
};
using I2cParts = std::function<I2cAnswer(const I2cMessage& message)>;

/// Hangs parts on a bus; they are asked when the exchange ends on the wire.
void attach(const I2cPort& port, I2cParts parts);
/// While held, recovery ends in kStuck.
void hold(const I2cPort& port, bool held);

/// Lets bytes arrive at wire speed from `at` on, followed by an idle line.
void receive(const UartPort& port, Time at, std::vector<std::uint8_t> bytes);
/// Called with every block the robot sends, when its last stop bit has left.
void on_sent(const UartPort& port, std::function<void(const std::vector<std::uint8_t>& bytes)> sink);

/// The pulse width driven now [ns]; 0: low.
std::uint32_t pulse(const PwmPort& port);

/// The level of an output pin, and setting an input.
bool pin(const GpioPort& port, std::uint8_t number);
void drive_pin(const GpioPort& port, std::uint8_t number, bool high);

}  // namespace finemote::host
