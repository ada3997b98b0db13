// PCA9685: an expander with sixteen PWM outputs.
#include "emulator/parts/pca9685.hpp"

#include "emulator/outfit/figures.hpp"
#include "emulator/outfit/models.hpp"
#include "emulator/outfit/rows.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

class ExpanderElement : public Element, public PulseSource {
 public:
  ExpanderElement(Outfit& outfit, const Json& part, const std::string& name)
      : Element(outfit, name), model(need<std::uint8_t>(part, "address")) {
    model.on_pulse = [this](unsigned channel, std::uint64_t pulse) {
      for (const Listener& tell : listeners_[channel]) tell({pulse, model.period_ns()});
    };
    model.on_command = [this](unsigned channel, std::uint64_t pulse, Tag origin) {
      record_output(channel, static_cast<double>(pulse), origin);
    };
    model.on_write = [this](unsigned channel, std::uint64_t pulse) {
      if (noted[channel] < 0) noted[channel] = static_cast<double>(pulse) / 1000;
    };
    outfit.line_of(part).attach(model);
  }
  bool listen(unsigned channel, Listener listener) override {
    if (channel >= listeners_.size()) return false;
    listeners_[channel].push_back(std::move(listener));
    return true;
  }

  Pca9685 model;
  std::array<double, 16> noted{};  ///< first pulse written since the last note [us]; -1: none yet

 private:
  std::array<std::vector<Listener>, 16> listeners_;
};

}  // namespace

Model pca9685() {
  using Row = Rows<ExpanderElement>;
  return {
      .type = "pca9685",
      .summary = "PWM outputs that change at the STOP",
      .is = {"pwm"},
      .figures = i2c_place() + std::vector{address(0x40)},
      .one_of = i2c_where(),
      .verbs = {violating("recovery", Row::fault("power_cycle", "loses its settings", {},
                                                 [](ExpanderElement& part, const Json&) { part.model.power_cycle(); })),
                Row::stimulus("note", "records the next pulse written to each output", {},
                              [](ExpanderElement& part, const Json&) { part.noted.fill(-1); })},
      .values = {Row::values("pulse_", "us", "", 15,
                             [](ExpanderElement& part, unsigned channel) {
                               return static_cast<double>(part.model.pulse_ns(channel)) / 1000;
                             }),
                 Row::values("noted_", "us", "the first pulse written after the last `note`, -1: none yet", 15,
                             [](ExpanderElement& part, unsigned channel) { return part.noted[channel]; }),
                 Row::value("bursts", "", "writes so far",
                            [](ExpanderElement& part) -> double { return part.model.bursts(); })},
      .make = Row::make,
  };
}

}  // namespace finemote::emulator
