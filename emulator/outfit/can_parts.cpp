// Parts on CAN buses.
#include "emulator/outfit.hpp"
#include "emulator/parts/dji_motor.hpp"

namespace finemote::emulator {
namespace {

DjiMotor::Figures figures_of(const Json& part) {
  DjiMotor::Figures f;
  f.feedback_id = need<std::uint32_t>(part, "feedback_id");
  f.command_id = need<std::uint32_t>(part, "command_id");
  f.word = need<unsigned>(part, "word");
  f.full_word = maybe(part, "full_word", f.full_word);
  f.full_current = maybe(part, "full_current", f.full_current);
  f.torque_per_ampere = maybe(part, "torque_per_ampere", f.torque_per_ampere);
  f.gear = maybe(part, "gear", f.gear);
  f.zero = maybe(part, "zero", f.zero);
  // Controllers do not know of each other: their reports are spread over the millisecond.
  const auto period = maybe<std::uint64_t>(part, "period_ns", 1'000'000);
  f.period = from_ns(period);
  f.phase = from_ns(maybe<std::uint64_t>(part, "phase_ns", f.feedback_id * 137'000ULL % period));
  if (f.word > 3 || f.full_word <= 0 || f.gear <= 0 || period == 0) refuse(part, "a figure is out of range");
  return f;
}

/// `torque_per_ampere` and `rotor_inertia` are at the rotor; everything else at the output.
MotorShaft::Parameters shaft_of(const Json& part, const DjiMotor::Figures& figures) {
  MotorShaft::Parameters p;
  p.inertia = maybe(part, "rotor_inertia", 0.0) * figures.gear * figures.gear + maybe(part, "load_inertia", 0.001);
  p.viscous = maybe(part, "viscous", p.viscous);
  p.coulomb = maybe(part, "coulomb", p.coulomb);
  p.free_speed = maybe(part, "free_rotor_speed", 1e9) / figures.gear;
  if (part.contains("lower")) p.lower = need<double>(part, "lower");
  if (part.contains("upper")) p.upper = need<double>(part, "upper");
  if (p.inertia <= 0 || p.free_speed <= 0) refuse(part, "inertia and free speed are above zero");
  return p;
}

class MotorElement : public Element, public ShaftSource {
 public:
  MotorElement(Outfit& outfit, const Json& part, const std::string& name, CanLine& line, DjiMotor::Figures figures)
      : outfit_(outfit), model_(outfit.board().world(), line, at_output(figures), shaft_of(part, figures)) {
    model_.on_report = [this, name](Time from) {
      outfit_.record(PartEvent{name, PartEvent::Kind::sample, 0, to_ns(from), outfit_.board().now_ns(), 0});
    };
    model_.on_command = [this, name](int word) {
      const std::uint64_t now = outfit_.board().now_ns();
      outfit_.record(PartEvent{name, PartEvent::Kind::output, 0, now, now, static_cast<double>(word)});
    };
    on("silent", [this](const Json& event) { model_.silent = maybe(event, "on", true); });
    on("damage", [this](const Json& event) { model_.damaged_reports = need<unsigned>(event, "frames"); });
    on("disturb", [this](const Json& event) {
      model_.shaft().load(outfit_.now(), MotorShaft::Load::scenario, need<double>(event, "torque"));
    });
    show("angle", [this] { return model_.shaft().angle(outfit_.now()); });
    show("speed", [this] { return model_.shaft().speed(outfit_.now()); });
    show("torque", [this] { return model_.shaft().torque(outfit_.now()); });
    show("current", [this] { return model_.current(); });
    show("command", [this] { return model_.command(); });
    show("commands", [this] { return model_.commands(); });
    show("resumed_with", [this] { return model_.resumed_with(); });
    show("pauses", [this] { return model_.pauses(); });
  }
  MotorShaft& shaft() override { return model_.shaft(); }

 private:
  static DjiMotor::Figures at_output(DjiMotor::Figures figures) {
    figures.torque_per_ampere *= figures.gear;
    return figures;
  }
  Outfit& outfit_;
  DjiMotor model_;
};

}  // namespace

std::unique_ptr<Element> make_dji_motor(Outfit& outfit, const Json& part, const std::string& name) {
  Can* can = outfit.board().chip().can(need<std::string>(part, "port"));
  if (can == nullptr) refuse(part, "the board has no such CAN port");
  return std::make_unique<MotorElement>(outfit, part, name, can->line, figures_of(part));
}

}  // namespace finemote::emulator
