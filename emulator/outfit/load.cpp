// What a pin of the board switches: a light, a sounder, a heater.
#include "emulator/outfit/figures.hpp"
#include "emulator/outfit/models.hpp"
#include "emulator/outfit/rows.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

class LoadElement : public Element {
 public:
  LoadElement(Outfit& outfit, const Json& part, const std::string& name) : Element(outfit, name), part_(part) {}
  void connect() override {
    outfit().listen_to_drive(part_, [this](Drive drive) { take(drive); });
  }

  [[nodiscard]] const Drive& drive() const { return drive_; }
  [[nodiscard]] double times_on() const { return times_on_; }
  /// Of its full power since power-on, 0..1.
  double mean() {
    add_up();
    return at_ == 0 ? 0 : on_time_ / static_cast<double>(at_);
  }

 private:
  void take(Drive drive) {
    add_up();
    if (drive_.share == 0 && drive.share > 0) ++times_on_;
    drive_ = drive;
  }
  void add_up() {
    on_time_ += drive_.share * static_cast<double>(now() - at_);
    at_ = now();
  }

  Json part_;
  Drive drive_;
  Time at_ = 0;          ///< up to which it is added up
  double on_time_ = 0;   ///< in units of Time, at full power
  double times_on_ = 0;  ///< whole
};

using LoadRow = Rows<LoadElement>;

}  // namespace

Model load() {
  return {
      .type = "load",
      .summary = "what the pin of a pulse output switches, also as a plain output: a light, a sounder, a heater",
      .figures = held_pulse_place("switches with"),
      .one_of = pulse_where(),
      .values = {LoadRow::value("share", "", "0 to 1 of its full power",
                                [](LoadElement& part) { return part.drive().share; }),
                 LoadRow::value("frequency", "Hz", "of its pulses; 0: none",
                                [](LoadElement& part) { return part.drive().hertz; }),
                 LoadRow::value("mean", "", "0 to 1 of its full power since power-on",
                                [](LoadElement& part) { return part.mean(); }),
                 LoadRow::value("times_on", "", "how often it was turned on so far",
                                [](LoadElement& part) { return part.times_on(); })},
      .make = LoadRow::make,
  };
}

}  // namespace finemote::emulator
