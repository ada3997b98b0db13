// The parts and plants of a scenario.
#include "emulator/scenario/build.hpp"

namespace finemote::scenario {
namespace {

constexpr double kDay = kLongest;

// ---- figures that several models share

std::vector<Member> serial_line() {
  return {required(port("serial")), required(integer("baud", "bit/s", "", 1, 10e6)), flag("even_parity", ""),
          integer("stop_bits", "", "", 1, 2)};
}

/// Of parts that speak by themselves.
std::vector<Member> pace() {
  return {integer("period_ns", "ns", "between two frames", 1, kDay),
          integer("phase_ns", "ns", "of the first", 0, kDay)};
}

std::vector<Member> i2c_place() {
  return {port("i2c"), part("mux", "mux", "in place of `port`: a mux on the bus"),
          integer("channel", "", "of the mux", 0, 7), integer("address", "", "7 bits", 0, 127)};
}

/// Of a part that has no usual address.
std::vector<Member> addressed(std::vector<Member> place) {
  for (Member& member : place) member.required = member.name == "address";
  return place;
}

std::vector<Member> pulse_place(const char* channel = "channel") {
  return {port("pwm"), part("pwm", "pwm", "in place of `port`: an expander"),
          integer(channel, "", "of the expander", 0, 15)};
}

std::vector<Member> joint_steps() {
  return {vector("xyz", "m", ""), vector("rpy", "rad", ""), vector("axis", "", ""),
          row(Kind::reference, "part", "", "what turns it")};
}

/// Of sensors that feel a body.
std::vector<Member> seat() {
  return {part("body", "body", "it sits on; without, events move it"),
          list(Kind::list, "way", "joints from the body to it", joint_steps())};
}

std::vector<Member> moved_by_hand() {
  return {number("roll", "deg", ""), number("pitch", "deg", ""), number("yaw", "deg", ""),
          vector("rate", "deg/s", "about its own axes"), vector("acceleration", "m/s^2", "along the world's axes")};
}

std::vector<Member> weight() {
  return {positive("mass", "kg", ""), row(Kind::six, "inertia", "kg m^2", "xx xy xz yy yz zz, about its origin")};
}

std::vector<Quantity> attitude() { return {{"roll", "deg", ""}, {"pitch", "deg", ""}, {"yaw", "deg", ""}}; }

std::vector<Quantity> motion() {
  std::vector<Quantity> values = attitude();
  values.insert(values.end(), {{"x", "m", ""}, {"y", "m", ""}, {"depth", "m", "below the world's z = 0"}});
  return values;
}

Verb move_by_hand() {
  return with_member(stimulus("move", "holds it in this pose; it no longer follows its body", moved_by_hand()));
}

Verb push() {
  return stimulus("disturb", "from now on; without members, no more",
                  {vector("force", "N", "along the world's axes"), vector("moment", "N m", "about the body's axes")});
}

Verb damaged(const char* summary) {
  return fault("damage", summary, {required(integer("frames", "", "how many", 1, 1e9))});
}

// ---- models by their buses

std::vector<Member> sticks() {
  std::vector<Member> members;
  for (const char* name : {"right_x", "right_y", "left_x", "left_y", "wheel"})
    members.push_back(number(name, "", "to the right and away from the operator", -1, 1));
  for (const char* name : {"left_switch", "right_switch"})
    members.push_back(choice(name, "", {"up", "middle", "down"}));
  members.push_back(integer("keys", "", "a bit each", 0, 65535));
  return members;
}

std::vector<Verb> remote_verbs() {
  return {with_member(stimulus("move", "what the operator does; the rest stays", sticks())), silent("sends nothing"),
          damaged("frames that lack a byte")};
}

void add_serial(std::vector<Model>& all) {
  all.push_back({"h30_imu",
                 "frames of attitude, rates and acceleration every `period_ns`",
                 {},
                 serial_line() + pace() + seat(),
                 {},
                 {silent("sends nothing"), damaged("frames with a wrong checksum"), move_by_hand()},
                 {{"frames", "", "sent so far"}}});
  all.push_back(
      {"dbus_receiver", "frames of a remote control every 14 ms", {}, serial_line() + pace(), {}, remote_verbs(), {}});
  std::vector<Verb> verbs = remote_verbs();
  verbs.push_back(
      fault("failsafe", "the receiver reports that it lost its transmitter", {flag("on", "false ends it")}));
  all.push_back({"sbus_receiver", "frames of a remote control every 14 ms", {}, serial_line() + pace(), {}, verbs, {}});
  all.push_back({"host_terminal",
                 "the remote end of a text serial line",
                 {},
                 serial_line(),
                 {},
                 {stimulus("send", "sends the text to the board", {required(text("text", ""))})},
                 {{"heard", "", "bytes received"}}});
}

void add_i2c(std::vector<Model>& all) {
  const std::vector<std::string> place{"port", "mux"};
  const Verb power_cycle = fault("power_cycle", "loses its settings", {});
  all.push_back({"tca9548a", "mux", {"mux"}, i2c_place(), place, {power_cycle}, {{"control", "", "its register"}}});
  all.push_back({"pca9685",
                 "PWM outputs that change at the STOP",
                 {"pwm"},
                 i2c_place(),
                 place,
                 {power_cycle, stimulus("note", "records the next pulse written to each output", {})},
                 {{"pulse_", "us", "", 15},
                  {"noted_", "us", "the first pulse written after the last `note`, -1: none yet", 15},
                  {"bursts", "", "writes so far"}}});
  all.push_back(
      {"ms5837",
       "conversions with their real duration; pressure from depth",
       {},
       i2c_place() + seat() +
           std::vector{choice("variant", "", {"30BA", "02BA"}), number("pressure", "Pa", "without a body", 0, 1e8)},
       place,
       {silent("does not answer"),
        fault("damage", "corrupts its PROM", {required(integer("bits", "", "mask of the bits that flip", 1, 65535))}),
        stimulus("move", "to where there is this pressure; it no longer follows its body",
                 {required(number("pressure", "Pa", "", 0, 1e8))})},
       {{"pressure", "Pa", ""}, {"conversions", "", "so far"}}});
  all.push_back({"ist8310",
                 "earth's magnetic field in the sensor's axes; reset pin on `i2c3`",
                 {},
                 i2c_place() + seat() + std::vector{vector("field", "T", "in the world's axes")},
                 place,
                 {silent("does not answer"), power_cycle,
                  with_member(stimulus("move", "holds it in this pose; it no longer follows its body",
                                       moved_by_hand() + std::vector{vector("field", "T", "in the world's axes")}))},
                 {}});
  const Member bytes = family(integer("r", "", "a register", 0, 255), 255);
  all.push_back(
      {"register_bank",
       "an I2C part of 256 plain registers, selected by the first byte written; replaces a part without a model",
       {},
       addressed(i2c_place()) + std::vector{bytes},
       place,
       {with_member(stimulus("set", "sets registers", {bytes}))},
       {{"r", "", "a register", 255}}});
}

void add_spi(std::vector<Model>& all) {
  Member heater = list(Kind::object, "heater", "its pulse output", pulse_place());
  heater.one_of = {"port", "pwm"};
  std::vector<Quantity> values = attitude();
  values.insert(values.end(),
                {{"temperature", "degrees Celsius", ""}, {"heat", "", "0 to 1: its heater's share of full power"}});
  all.push_back(
      {"bmi088",
       "two chips, their wake-up, ranges, rates and sensor time, data-ready outputs and temperature",
       {},
       std::vector{required(port("spi")), required(integer("channel", "", "chip select of the accelerometer", 0, 1)),
                   required(integer("gyro", "", "chip select of the gyroscope", 0, 1)),
                   row(Kind::pin, "ready", "", "at INT3"), heater, number("ambient", "degrees Celsius", "", -60, 150),
                   number("heater_rise", "K", "at full power", 0, 1000), positive("heater_time_constant", "s", "")} +
           seat(),
       {},
       {silent("does not answer, and gives no edges"), fault("power_cycle", "loses its settings", {}),
        fault("cut", "breaks the wires of its data-ready outputs", {flag("on", "false mends them")}),
        stimulus("heat", "sets its temperature",
                 {required(number("temperature", "degrees Celsius", "from which it continues", -60, 150))}),
        move_by_hand()},
       values});
}

void add_can(std::vector<Model>& all) {
  all.push_back(
      {"dji_motor",
       "C620 with M3508, C610 with M2006, GM6020: receives a word of the group frame, sends a report every "
       "millisecond; keeps the last current when commands stop",
       {"shaft"},
       std::vector{required(port("can")), integer("id", "", "", 1, 8),
                   required(integer("feedback_id", "", "of its reports", 0, 2047)),
                   required(integer("command_id", "", "of the group frame", 0, 2047)),
                   required(integer("word", "", "in the group frame", 0, 3)), positive("full_word", "", "of a command"),
                   number("full_current", "A", "", 0), number("torque_per_ampere", "N m/A", "at the rotor", 0),
                   number("rotor_inertia", "kg m^2", "", 0), positive("free_rotor_speed", "rad/s", ""),
                   positive("gear", "", ""), number("zero", "rad", ""),
                   positive("load_inertia", "kg m^2", "at the output, and so the rest"),
                   number("viscous", "N m s", "", 0), number("coulomb", "N m", "", 0), number("lower", "rad", ""),
                   number("upper", "rad", "")} +
           pace(),
       {},
       {silent("reports nothing; a silent controller still obeys"), damaged("frames with an impossible angle"),
        stimulus("disturb", "from now on", {required(number("torque", "N m", "on the output"))})},
       {{"angle", "rad", "of the output"},
        {"speed", "rad/s", "of the output"},
        {"torque", "N m", "of the output"},
        {"command", "", "as commanded"},
        {"current", "A", "as commanded"},
        {"commands", "", "received so far"},
        {"pauses", "", "of more than 8 ms between commands"},
        {"resumed_with", "", "the first command after the last pause"}}});
}

void add_pwm(std::vector<Model>& all) {
  const std::vector<std::string> place{"port", "pwm"};
  const std::vector<Quantity> pulse{{"pulse", "us", ""},
                                    {"resumed_with", "us", "the first pulse after the output was off"}};
  std::vector<Quantity> values = pulse;
  values.insert(values.end(), {{"drive", "", "-1 to 1, along the axis"}, {"thrust", "N", "along the axis"}});
  all.push_back({"pwm_output", "a pulse to observe", {}, pulse_place(), place, {}, pulse});
  all.push_back(
      {"thruster",
       "converts pulses to thrust, quadratic in the drive with a lag of 50 ms; pushes a body",
       {},
       pulse_place() + std::vector{positive("neutral", "ns", ""), positive("min", "ns", ""), positive("max", "ns", ""),
                                   flag("reverse", "turns the other way"), number("full_thrust", "N", "", 0),
                                   number("lag", "s", "", 0, 60), part("body", "hull", "it pushes"),
                                   vector("xyz", "m", ""), vector("axis", "", "")},
       place,
       {},
       values});
}

void add_bodies(std::vector<Model>& all) {
  all.push_back({"standing_body",
                 "stays still until events move it",
                 {"body"},
                 {},
                 {},
                 {with_member(stimulus("move", "holds it in this pose", moved_by_hand()))},
                 motion()});
  all.push_back({"submerged_body",
                 "floating rigid body with added mass, drag, and buoyancy above its centre of mass",
                 {"body", "hull"},
                 weight() + std::vector{number("added_mass", "", "share of mass and inertia", 0),
                                        number("linear_drag", "N s/m", "per kg", 0),
                                        number("quadratic_drag", "N s^2/m^2", "per kg", 0),
                                        number("buoyancy", "", "lift as share of the weight"),
                                        number("righting", "m", "centre of buoyancy above that of mass")},
                 {},
                 {push()},
                 motion()});
  all.push_back({"mecanum_base",
                 "rolls on the `wheels` that motors turn, and slides where they push too hard",
                 {"body"},
                 weight() + std::vector{required(positive("wheel_radius", "m", "")),
                                        required(list(Kind::list, "wheels", "",
                                                      {required(part("part", "shaft", "that turns it")),
                                                       vector("xyz", "m", ""), vector("axis", "", "")})),
                                        positive("grip", "N s/m", "force of a contact per speed of sliding"),
                                        number("friction", "", "of a contact", 0), number("drag", "N s/m", "", 0)},
                 {},
                 {push()},
                 motion()});
  all.push_back(
      {"weights",
       "applies the weight behind driven joints to them, on a still or moving body",
       {},
       {required(part("body", "body", "")),
        required(list(Kind::list, "joints", "",
                      {required(row(Kind::reference, "part", "", "that turns it")),
                       row(Kind::reference, "before", "", "the part of the joint that carries it"),
                       list(Kind::list, "way", "from there, or from the body", joint_steps()), vector("axis", "", ""),
                       required(number("mass", "kg", "", 0)), vector("centre", "m", "of that mass")}))},
       {},
       {},
       {}});
}

}  // namespace

const std::vector<Model>& models() {
  static const std::vector<Model> kModels = [] {
    std::vector<Model> all;
    add_serial(all);
    add_i2c(all);
    add_spi(all);
    add_can(all);
    add_pwm(all);
    add_bodies(all);
    return all;
  }();
  return kModels;
}

}  // namespace finemote::scenario
