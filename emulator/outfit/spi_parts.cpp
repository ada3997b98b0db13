// Parts on SPI buses.
#include <map>

#include "emulator/outfit/bodies.hpp"
#include "emulator/parts/bmi088.hpp"
#include "emulator/plants/heated_mass.hpp"

namespace finemote::emulator {
namespace {

HeatedMass::Parameters mass_of(const Json& part) {
  HeatedMass::Parameters p;
  p.ambient = maybe(part, "ambient", p.ambient);
  p.rise = maybe(part, "heater_rise", p.rise);
  p.time_constant = maybe(part, "heater_time_constant", p.time_constant);
  if (p.rise < 0 || p.time_constant <= 0) refuse(part, "a figure of the heater is out of range");
  return p;
}

class Bmi088Element : public Element {
 public:
  Bmi088Element(Outfit& outfit, const Json& part, const std::string& name)
      : outfit_(outfit),
        part_(part),
        seat_(part),
        mass_(mass_of(part)),
        model_(
            {[&outfit] { return outfit.now(); },
             [&outfit](Time at, EventQueue::Action action) { outfit.board().world().at(at, std::move(action)); }},
            [this](Time now) { return seat_.motion(now); }, [this](Time now) { return mass_.temperature(now); }) {
    const auto port = need<std::string>(part, "port");
    const auto accelerometer = need<unsigned>(part, "channel"), gyroscope = need<unsigned>(part, "gyro");
    const bool placed = outfit.board().chip().attach_spi(port, accelerometer, model_.accelerometer()) &&
                        outfit.board().chip().attach_spi(port, gyroscope, model_.gyroscope());
    if (!placed) refuse(part, "the board has no such SPI port or chip select");
    // The part on the board is wired, whatever its entry says.
    const bool on_board = port == "spi1" && accelerometer == 0 && gyroscope == 1;
    if (on_board) connect_output(Bmi088::Output::int1, "PC4");
    const std::string ready = on_board ? "PC5" : maybe<std::string>(part, "ready", "");
    if (!ready.empty()) connect_output(Bmi088::Output::int3, ready);
    add_actions();
    add_values();
    model_.on_output = [this](Bmi088::Output output, int level) { drive(output, level); };
    model_.on_read = [this, name](Time from) {
      outfit_.record(PartEvent{name, PartEvent::Kind::sample, 0, to_ns(from), outfit_.board().now_ns(), 0});
    };
  }
  void connect(Outfit& outfit) override {
    seat_.connect(outfit);
    if (!part_.contains("heater")) return;
    outfit.listen_to_pulses(need<Json>(part_, "heater"), [this](Timer::Pulse pulse) {
      const double period = static_cast<double>(pulse.period_ns);
      mass_.heat(outfit_.now(), pulse.period_ns == 0 ? 0 : static_cast<double>(pulse.width_ns) / period);
    });
  }

 private:
  void add_actions() {
    on("silent", [this](const Json& event) { model_.silent = maybe(event, "on", true); });
    on("power_cycle", [this](const Json&) { model_.power_cycle(); });
    on("cut", [this](const Json& event) { cut(maybe(event, "on", true)); });
    on("heat", [this](const Json& event) { mass_.set(outfit_.now(), need<double>(event, "temperature")); });
    on("move", [this](const Json& event) { seat_.move(outfit_.now(), event); });
  }
  void add_values() {
    const auto now = [this] { return seat_.motion(outfit_.now()); };
    show("roll", [now] { return degrees_of(now(), &Angles::roll); });
    show("pitch", [now] { return degrees_of(now(), &Angles::pitch); });
    show("yaw", [now] { return degrees_of(now(), &Angles::yaw); });
    show("temperature", [this] { return mass_.temperature(outfit_.now()); });
    show("heat", [this] { return mass_.share(); });
  }
  void connect_output(Bmi088::Output output, const std::string& pin) {
    wires_[output] = {&outfit_.board().chip().gpio(pin[1]), static_cast<unsigned>(std::stoul(pin.substr(2)))};
  }
  /// The wires of its outputs break, or are mended.
  void cut(bool cut) {
    cut_ = cut;
    for (const auto& [output, level] : levels_) drive(output, level);
  }
  void drive(Bmi088::Output output, int level) {
    levels_[output] = level;
    const auto wire = wires_.find(output);
    if (wire != wires_.end()) wire->second.first->drive(wire->second.second, cut_ ? -1 : level);
  }

  Outfit& outfit_;
  Json part_;
  Seat seat_;
  HeatedMass mass_;
  Bmi088 model_;
  std::map<Bmi088::Output, std::pair<Gpio*, unsigned>> wires_;
  std::map<Bmi088::Output, int> levels_;
  bool cut_ = false;
};

}  // namespace

std::unique_ptr<Element> make_bmi088(Outfit& outfit, const Json& part, const std::string& name) {
  return std::make_unique<Bmi088Element>(outfit, part, name);
}

}  // namespace finemote::emulator
