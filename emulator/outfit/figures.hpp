// Figures that the entries of several parts share.
#pragma once

#include "emulator/scenario/build.hpp"

namespace finemote::emulator {

/// Data sheets of these parts do not say how exact their clocks are: as of a ceramic resonator (Murata CSTCE, 0.5 %
/// initial, 0.2 % over temperature, 0.1 % with age).
inline constexpr double kResonatorTolerancePpm = 8'000;

/// A serial line of its own: `port` and format.
std::vector<scenario::Member> serial_line();
/// Of parts that speak by themselves, usually every `period_ns` of their own clock.
std::vector<scenario::Member> pace(double period_ns);
/// A place on an I2C bus, or behind a mux; the entry has one_of i2c_where().
std::vector<scenario::Member> i2c_place();
std::vector<std::string> i2c_where();
/// The address of a part on an I2C bus, which usually is this.
scenario::Member address(unsigned usual);
/// A PWM header or an output of an expander; the entry has one_of pulse_where().
std::vector<scenario::Member> pulse_place();
std::vector<std::string> pulse_where();
/// The same, as what only one part can have: `verb` as `has`.
std::vector<scenario::Member> held_pulse_place(const std::string& verb);
/// Steps over joints to where something is.
std::vector<scenario::Member> joint_steps();

}  // namespace finemote::emulator
