// BMI088: an accelerometer and a gyroscope, kept warm by a heater.
#include "emulator/parts/bmi088.hpp"

#include <array>
#include <map>

#include "emulator/outfit/figures.hpp"
#include "emulator/outfit/models.hpp"
#include "emulator/outfit/rows.hpp"
#include "emulator/outfit/sampling.hpp"
#include "emulator/outfit/seat.hpp"
#include "emulator/plants/heated_mass.hpp"
#include "emulator/scenario/check.hpp"
#include "emulator/scenario/figures.hpp"
#include "generator/diagnostic/code_scenario.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

/// How far the rates of samples may be off: 5 %, data sheet BST-BMI088-DS001 1.2, table 3. That is about the
/// accelerometer, and is taken for the gyroscope too.
constexpr double kDataRatePpm = 50'000;

class Bmi088Element : public SeatedElement {
 public:
  Bmi088Element(Outfit& outfit, const Json& part, const std::string& name)
      : SeatedElement(outfit, part, name),
        mass({need<double>(part, "ambient"), need<double>(part, "heater_rise"),
              need<double>(part, "heater_time_constant")}),
        clock(own_clock(part_clock(), part)),
        model(
            clock.part_clock(), [this](Time at) { return motion(clock.board(at)); },
            [this](Time at) { return mass.temperature(clock.board(at)); }),
        part_(part) {
    const auto port = need<std::string>(part, "port");
    const auto accelerometer = need<unsigned>(part, "channel"), gyroscope = need<unsigned>(part, "gyro");
    const bool placed = outfit.board().chip().attach_spi(port, accelerometer, model.accelerometer()) &&
                        outfit.board().chip().attach_spi(port, gyroscope, model.gyroscope());
    if (!placed) refuse(part, "the board has no such SPI port or chip select");
    // The part on the board is wired, whatever its entry says.
    const bool on_board = port == "spi1" && accelerometer == 0 && gyroscope == 1;
    if (on_board) connect_output(Bmi088::Output::int1, "PC4");
    const std::string ready = on_board ? "PC5" : maybe<std::string>(part, "ready", "");
    if (!ready.empty()) connect_output(Bmi088::Output::int3, ready);
    model.on_output = [this](Bmi088::Output output, int level) { drive(output, level); };
    // Channel 0: rates, 1: acceleration.
    model.on_sample = [this](Bmi088::Quantity quantity, Time from) {
      return begin_sample(static_cast<unsigned>(quantity), clock.board(from));
    };
    model.on_read = [this](Bmi088::Quantity quantity, Tag sample) {
      ++reads[static_cast<std::size_t>(quantity)];
      end_sample(static_cast<unsigned>(quantity), sample);
    };
  }
  void connect() override {
    SeatedElement::connect();
    if (!part_.contains("heater")) return;
    outfit().listen_to_drive(need<Json>(part_, "heater"), [this](Drive drive) { mass.heat(now(), drive.share); });
  }
  /// The wires of its outputs break, or are mended.
  void cut(bool cut) {
    cut_ = cut;
    for (const auto& [output, level] : levels_) drive(output, level);
  }
  void heat_to(double celsius) { mass.set(now(), celsius); }
  Motion motion_now() { return motion(now()); }
  double temperature_now() { return mass.temperature(now()); }

  HeatedMass mass;
  std::array<std::uint64_t, 2> reads{};  ///< of rates, of acceleration
  OwnClock clock;                        ///< of both chips; `model` counts by it, all others by the board's
  Bmi088 model;

 private:
  void connect_output(Bmi088::Output output, const std::string& pin) {
    const auto [port, number] = pin_place(pin);
    wires_[output] = {&outfit().board().chip().gpio(port), number};
  }
  void drive(Bmi088::Output output, int level) {
    levels_[output] = level;
    const auto wire = wires_.find(output);
    if (wire != wires_.end()) wire->second.first->drive(wire->second.second, cut_ ? -1 : level);
  }

  Json part_;
  std::map<Bmi088::Output, std::pair<Gpio*, unsigned>> wires_;
  std::map<Bmi088::Output, int> levels_;
  bool cut_ = false;
};

using Bmi088Row = Rows<Bmi088Element>;

std::vector<Member> bmi088_figures() {
  const HeatedMass::Parameters usual;
  Member heater = list(Kind::object, "heater", "its pulse output", pulse_place());
  heater.one_of = pulse_where();
  return {required(port("spi")),
          held("has chip select", required(integer("channel", "", "chip select of the accelerometer", 0, 1))),
          held("has chip select", required(integer("gyro", "", "chip select of the gyroscope", 0, 1))),
          row(Kind::pin, "ready", "", "at INT3"),
          heater,
          usually(usual.ambient, number("ambient", "degrees Celsius", "", -60, 150)),
          usually(usual.rise, number("heater_rise", "K", "at full power", 0, 1000)),
          usually(usual.time_constant, positive("heater_time_constant", "s", ""))};
}

/// The board has these chip selects, and they are two.
void check_selects(const gen::json::Value& entry, const Model& model, const scenario::World& world,
                   gen::Diagnostics& diagnostics) {
  const gen::json::Value* port = word_in(entry, "port");
  const PortKind* kind = port == nullptr ? nullptr : kind_of_port(port->text);
  if (kind == nullptr || kind->name != "spi") return;
  const auto known = world.selects.find(port->text);
  if (known == world.selects.end() && world.selects.empty()) return;  // not known
  const unsigned count = known == world.selects.end() ? 0 : known->second;
  for (const char* key : {"channel", "gyro"}) {
    const auto select = figure(entry, model, key);
    if (!select || *select < count) continue;
    diagnostics
        .error(gen::code::scenario_range, entry.find(key)->at,
               fmt::format("'{}' has no chip select {}", port->text, *select))
        .underline(entry.find(key)->length)
        .note(count == 0 ? "the board has none there" : fmt::format("the board has {} there, from 0 on", count));
  }
  const auto accelerometer = figure(entry, model, "channel"), gyroscope = figure(entry, model, "gyro");
  if (!accelerometer || accelerometer != gyroscope) return;
  diagnostics
      .error(gen::code::scenario_range, entry.find("gyro")->at,
             fmt::format("'channel' and 'gyro' are both chip select {}", *gyroscope))
      .underline(entry.find("gyro")->length);
}

std::vector<Verb> bmi088_verbs() {
  return {Bmi088Row::fault("silent", "does not answer, and gives no edges", {until()},
                           [](Bmi088Element& part, const Json& event) { part.model.silent = is_on(event); }),
          violating("recovery", Bmi088Row::fault("power_cycle", "loses its settings", {},
                                                 [](Bmi088Element& part, const Json&) { part.model.power_cycle(); })),
          Bmi088Row::fault("cut", "breaks the wires of its data-ready outputs", {until("false mends them")},
                           [](Bmi088Element& part, const Json& event) { part.cut(is_on(event)); }),
          Bmi088Row::stimulus(
              "heat", "sets its temperature",
              {required(number("temperature", "degrees Celsius", "from which it continues", -60, 150))},
              [](Bmi088Element& part, const Json& event) { part.heat_to(need<double>(event, "temperature")); }),
          SeatedElement::move_verb()};
}

std::vector<Quantity> bmi088_values() {
  return {Bmi088Row::value("roll", "deg", "",
                           [](Bmi088Element& part) { return degrees_of(part.motion_now(), &Angles::roll); }),
          Bmi088Row::value("pitch", "deg", "",
                           [](Bmi088Element& part) { return degrees_of(part.motion_now(), &Angles::pitch); }),
          Bmi088Row::value("yaw", "deg", "",
                           [](Bmi088Element& part) { return degrees_of(part.motion_now(), &Angles::yaw); }),
          Bmi088Row::value("temperature", "degrees Celsius", "",
                           [](Bmi088Element& part) { return part.temperature_now(); }),
          Bmi088Row::value("heat", "", "0 to 1: its heater's share of full power",
                           [](Bmi088Element& part) { return part.mass.share(); }),
          Bmi088Row::value("rate_reads", "", "so far",
                           [](Bmi088Element& part) { return static_cast<double>(part.reads[0]); }),
          Bmi088Row::value("acceleration_reads", "", "so far",
                           [](Bmi088Element& part) { return static_cast<double>(part.reads[1]); })};
}

}  // namespace

Model bmi088() {
  return {
      .type = "bmi088",
      .summary = "two chips, their wake-up, ranges, rates and sensor time, data-ready outputs and temperature",
      .figures = bmi088_figures() + sampling() + seat(),
      .clock_tolerance_ppm = kDataRatePpm,
      .verbs = bmi088_verbs(),
      .values = bmi088_values(),
      .make = Bmi088Row::make,
      .check = check_selects,
  };
}

}  // namespace finemote::emulator
