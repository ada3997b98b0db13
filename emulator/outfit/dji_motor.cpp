// DJI's motors with their controllers.
#include "emulator/parts/dji_motor.hpp"

#include "emulator/outfit/figures.hpp"
#include "emulator/outfit/models.hpp"
#include "emulator/outfit/rows.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

/// Torque at the output.
DjiMotor::Figures figures_of(const Json& part) {
  DjiMotor::Figures f;
  f.feedback_id = need<std::uint32_t>(part, "feedback_id");
  f.command_id = need<std::uint32_t>(part, "command_id");
  f.word = need<unsigned>(part, "word");
  f.full_word = need<double>(part, "full_word");
  f.full_current = need<double>(part, "full_current");
  f.gear = need<double>(part, "gear");
  f.torque_per_ampere = need<double>(part, "torque_per_ampere") * f.gear;
  f.zero = need<double>(part, "zero");
  // Controllers do not know of each other: their reports are spread over the millisecond.
  const auto period = need<std::uint64_t>(part, "period_ns");
  f.period = period_of(part);
  f.phase = from_ns(maybe<std::uint64_t>(part, "phase_ns", f.feedback_id * 137'000ULL % period));
  return f;
}

/// `torque_per_ampere` and `rotor_inertia` are at the rotor; everything else at the output.
MotorShaft::Parameters shaft_of(const Json& part) {
  const auto gear = need<double>(part, "gear");
  MotorShaft::Parameters p;
  p.inertia = need<double>(part, "rotor_inertia") * gear * gear + need<double>(part, "load_inertia");
  p.viscous = need<double>(part, "viscous");
  p.coulomb = need<double>(part, "coulomb");
  p.free_speed = need<double>(part, "free_rotor_speed") / gear;
  if (part.contains("lower")) p.lower = need<double>(part, "lower");
  if (part.contains("upper")) p.upper = need<double>(part, "upper");
  return p;
}

class MotorElement : public Element, public ShaftSource {
 public:
  MotorElement(Outfit& outfit, const Json& part, const std::string& name)
      : Element(outfit, name), model(outfit.board().world(), outfit.can_of(part), figures_of(part), shaft_of(part)) {
    model.on_sample = [this] { return begin_sample(0, now()); };
    model.on_report = [this](Tag sample) { end_sample(0, sample); };
    model.on_command = [this](int word, Tag origin) { record_output(0, static_cast<double>(word), origin); };
  }
  MotorShaft& shaft() override { return model.shaft(); }
  void disturb(double torque) { shaft().load(now(), MotorShaft::Load::scenario, torque); }
  double angle() { return shaft().angle(now()); }
  double speed() { return shaft().speed(now()); }
  double torque() { return shaft().torque(now()); }

  DjiMotor model;
};

using MotorRow = Rows<MotorElement>;

std::vector<Member> motor_figures() {
  const DjiMotor::Figures usual;
  const MotorShaft::Parameters shaft;
  return {required(port("can")),
          integer("id", "", "", 1, 8),
          held("has the identifier", required(integer("feedback_id", "", "of its reports", 0, 2047))),
          required(integer("command_id", "", "of the group frame", 0, 2047)),
          required(integer("word", "", "in the group frame", 0, 3)),
          usually(usual.full_word, positive("full_word", "", "of a command")),
          usually(usual.full_current, number("full_current", "A", "", 0)),
          usually(usual.torque_per_ampere, number("torque_per_ampere", "N m/A", "at the rotor", 0)),
          usually(0, number("rotor_inertia", "kg m^2", "", 0)),
          usually(shaft.free_speed, positive("free_rotor_speed", "rad/s", "")),
          usually(usual.gear, positive("gear", "", "")),
          usually(usual.zero, number("zero", "rad", "")),
          usually(0.001, positive("load_inertia", "kg m^2", "at the output, and so the rest")),
          usually(shaft.viscous, number("viscous", "N m s", "", 0)),
          usually(shaft.coulomb, number("coulomb", "N m", "", 0)),
          number("lower", "rad", ""),
          number("upper", "rad", "")};
}

std::vector<Verb> motor_verbs() {
  return {
      MotorRow::fault("silent", "reports nothing; a silent controller still obeys", {until()},
                      [](MotorElement& part, const Json& event) { part.model.silent = is_on(event); }),
      MotorRow::fault(
          "damage", "frames with an impossible angle", {count("frames")},
          [](MotorElement& part, const Json& event) { part.model.damaged_reports = need<unsigned>(event, "frames"); }),
      MotorRow::stimulus("disturb", "from now on", {required(number("torque", "N m", "on the output"))},
                         [](MotorElement& part, const Json& event) { part.disturb(need<double>(event, "torque")); })};
}

std::vector<Quantity> motor_values() {
  return {
      MotorRow::value("angle", "rad", "of the output", [](MotorElement& part) { return part.angle(); }),
      MotorRow::value("speed", "rad/s", "of the output", [](MotorElement& part) { return part.speed(); }),
      MotorRow::value("torque", "N m", "of the output", [](MotorElement& part) { return part.torque(); }),
      MotorRow::value("command", "", "as commanded", [](MotorElement& part) -> double { return part.model.command(); }),
      MotorRow::value("current", "A", "as commanded",
                      [](MotorElement& part) -> double { return part.model.current(); }),
      MotorRow::value("commands", "", "received so far",
                      [](MotorElement& part) -> double { return part.model.commands(); }),
      MotorRow::value("pauses", "", "of more than 8 ms between commands",
                      [](MotorElement& part) -> double { return part.model.pauses(); }),
      MotorRow::value("resumed_with", "", "the first command after the last pause",
                      [](MotorElement& part) -> double { return part.model.resumed_with(); })};
}

}  // namespace

Model dji_motor() {
  return {
      .type = "dji_motor",
      .summary =
          "C620 with M3508, C610 with M2006, GM6020: receives a word of the group frame, sends a report every "
          "millisecond; keeps the last current when commands stop",
      .is = {"shaft"},
      .figures = motor_figures() + pace(1e6),
      .clock_tolerance_ppm = kResonatorTolerancePpm,
      .verbs = motor_verbs(),
      .values = motor_values(),
      .make = MotorRow::make,
  };
}

}  // namespace finemote::emulator
