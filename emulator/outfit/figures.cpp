#include "emulator/outfit/figures.hpp"

#include "emulator/outfit/sampling.hpp"

namespace finemote::emulator {

using namespace scenario;

std::vector<Member> serial_line() {
  return {held("has the serial port", required(port("serial"))), required(integer("baud", "bit/s", "", 1, 10e6)),
          flag("even_parity", ""), usually(1, integer("stop_bits", "", "", 1, 2))};
}

std::vector<Member> pace(double period_ns) {
  return {usually(period_ns, integer("period_ns", "ns", "between two frames", 1, kLongest)),
          integer("phase_ns", "ns", "of the first", 0, kLongest), clock_error()};
}

std::vector<Member> i2c_place() {
  return {port("i2c"), part("mux", "mux", "in place of `port`: a mux on the bus"),
          integer("channel", "", "of the mux", 0, 7)};
}

std::vector<std::string> i2c_where() { return {"port", "mux"}; }

Member address(unsigned usual) { return usually(usual, integer("address", "", "7 bits", 0, 127)); }

std::vector<Member> pulse_place() {
  return {port("pwm"), part("pwm", "pwm", "in place of `port`: an expander"),
          integer("channel", "", "of the expander", 0, 15)};
}

std::vector<std::string> pulse_where() { return {"port", "pwm"}; }

std::vector<Member> held_pulse_place(const std::string& verb) {
  std::vector<Member> place = pulse_place();
  place[0].holds = verb + " the output";
  place[2].holds = verb + " output";
  return place;
}

std::vector<Member> joint_steps() {
  return {vector3("xyz", "m", ""), vector3("rpy", "rad", ""), vector3("axis", "", ""),
          row(Kind::reference, "part", "", "what turns it")};
}

}  // namespace finemote::emulator
