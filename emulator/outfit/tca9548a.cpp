// TCA9548A: an I2C mux.
#include "emulator/parts/tca9548a.hpp"

#include "emulator/outfit/figures.hpp"
#include "emulator/outfit/models.hpp"
#include "emulator/outfit/rows.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

class MuxElement : public Element, public LineSource {
 public:
  MuxElement(Outfit& outfit, const Json& part, const std::string& name)
      : Element(outfit, name), model(need<std::uint8_t>(part, "address")) {
    outfit.line_of(part).attach(model);
  }
  I2cLine* line(unsigned channel) override { return channel < 8 ? &model.channel(channel) : nullptr; }

  Tca9548a model;
};

}  // namespace

Model tca9548a() {
  using Row = Rows<MuxElement>;
  return {
      .type = "tca9548a",
      .summary = "mux",
      .is = {"mux"},
      .figures = i2c_place() + std::vector{address(0x70)},
      .one_of = i2c_where(),
      .verbs = {violating("recovery", Row::fault("power_cycle", "loses its settings", {},
                                                 [](MuxElement& part, const Json&) { part.model.power_cycle(); }))},
      .values = {Row::value("control", "", "its register",
                            [](MuxElement& part) -> double { return part.model.control(); })},
      .make = Row::make,
  };
}

}  // namespace finemote::emulator
