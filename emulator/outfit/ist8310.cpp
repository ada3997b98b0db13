// IST8310: a magnetometer.
#include "emulator/parts/ist8310.hpp"

#include "emulator/outfit/figures.hpp"
#include "emulator/outfit/models.hpp"
#include "emulator/outfit/rows.hpp"
#include "emulator/outfit/sampling.hpp"
#include "emulator/outfit/seat.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

class CompassElement : public SeatedElement {
 public:
  CompassElement(Outfit& outfit, const Json& part, const std::string& name)
      : SeatedElement(outfit, part, name),
        field(vector(part, "field")),
        clock(own_clock(part_clock(), part)),
        model(need<std::uint8_t>(part, "address"), clock.part_clock(),
              [this](Time at) { return Eigen::Vector3d(motion(clock.board(at)).attitude.conjugate() * field); }) {
    model.on_read = [this](Time from) {
      ++reads;
      return record_sample(clock.board(from), now());
    };
    outfit.line_of(part).attach(model);
    if (maybe<std::string>(part, "port", "") != "i2c3") return;
    // The part on the board has its reset at PG6 and its data-ready output at PG3.
    Gpio& port = outfit.board().chip().gpio('G');
    port.watcher[6] = [this](bool output, bool high) { model.hold_reset(output && !high); };
    model.on_ready = [&port](int level) { port.drive(3, level); };
  }

  Eigen::Vector3d field;  ///< in the world's axes [T]
  std::uint64_t reads = 0;
  OwnClock clock;  ///< `model` counts by it, all others by the board's
  Ist8310 model;
};

void silence(CompassElement& part, const Json& event) { part.model.dead = is_on(event); }

void power_cycle(CompassElement& part, const Json&) { part.model.power_cycle(); }

void move(CompassElement& part, const Json& event) {
  part.field = vector(event, "field", part.field);
  part.move(event);
}

Member earths_field() { return vector3("field", "T", "in the world's axes"); }

}  // namespace

Model ist8310() {
  using Row = Rows<CompassElement>;
  return {
      .type = "ist8310",
      .summary = "earth's magnetic field in the sensor's axes; reset and data-ready pins on `i2c3`",
      .figures = i2c_place() + std::vector{address(0x0E)} + sampling() + seat() +
                 std::vector{usually({20e-6, 0, -45e-6}, earths_field())},
      .one_of = i2c_where(),
      .clock_tolerance_ppm = kResonatorTolerancePpm,
      .verbs = {Row::fault("silent", "does not answer", {until()}, silence),
                violating("recovery", Row::fault("power_cycle", "loses its settings", {}, power_cycle)),
                with_member(Row::stimulus("move", "holds it in this pose; it no longer follows its body",
                                          pose() + std::vector{earths_field()}, move))},
      .values = {Row::value("measurements", "", "so far",
                            [](CompassElement& part) { return static_cast<double>(part.model.measurements()); }),
                 Row::value("reads", "", "measurements fetched so far",
                            [](CompassElement& part) { return static_cast<double>(part.reads); })},
      .make = Row::make,
  };
}

}  // namespace finemote::emulator
