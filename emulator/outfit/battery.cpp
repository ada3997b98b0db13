// A supply voltage that a converter measures behind a divider.
#include "emulator/outfit/models.hpp"
#include "emulator/outfit/rows.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

class BatteryElement : public Element {
 public:
  BatteryElement(Outfit& outfit, const Json& part, const std::string& name)
      : Element(outfit, name), input_(need<unsigned>(part, "input")), divider_(need<double>(part, "divider")) {
    const auto port = need<std::string>(part, "port");
    converter_ = outfit.board().chip().adc(port);
    if (converter_ == nullptr) refuse(part, "the chip has no such converter");
    set(need<double>(part, "volts"));
  }

  void set(double volts) {
    volts_ = volts;
    converter_->volts[input_] = volts / divider_;
  }
  [[nodiscard]] double volts() const { return volts_; }
  [[nodiscard]] unsigned conversions() const { return converter_->conversions(); }

 private:
  Adc* converter_ = nullptr;
  unsigned input_;
  double divider_, volts_ = 0;
};

using BatteryRow = Rows<BatteryElement>;

Member volts() { return number("volts", "V", "of the battery", 0, 1000); }

}  // namespace

Model battery() {
  return {
      .type = "battery",
      .summary = "a supply voltage at an input of a converter",
      .figures = {required(port("adc")),
                  held("is measured at input", required(integer("input", "", "of the converter", 0, 15))),
                  usually(24, volts()), usually(1, positive("divider", "", "its volts for one at the pin"))},
      .verbs = {BatteryRow::stimulus(
          "charge", "to another voltage", {required(volts())},
          [](BatteryElement& part, const Json& event) { part.set(need<double>(event, "volts")); })},
      .values = {BatteryRow::value("volts", "V", "", [](BatteryElement& part) { return part.volts(); }),
                 BatteryRow::value("conversions", "", "of its converter so far",
                                   [](BatteryElement& part) { return double(part.conversions()); })},
      .make = BatteryRow::make,
  };
}

}  // namespace finemote::emulator
