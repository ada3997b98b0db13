// A push button between a pin and one of the supplies.
#include "emulator/outfit/models.hpp"
#include "emulator/outfit/rows.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

class ButtonElement : public Element {
 public:
  ButtonElement(Outfit& outfit, const Json& part, const std::string& name)
      : Element(outfit, name),
        pin_(pin_place(need<std::string>(part, "pin"))),
        gpio_(outfit.board().chip().gpio(pin_.port)),
        pressed_level_(need<std::string>(part, "active") == "high" ? 1 : 0) {}

  /// Released it leaves the pin to the chip's own resistors.
  void hold(bool down) {
    constexpr int kNothing = -1;
    if (down && !is_down_) ++presses_;
    is_down_ = down;
    gpio_.drive(pin_.number, down ? pressed_level_ : kNothing);
  }
  [[nodiscard]] bool is_down() const { return is_down_; }
  [[nodiscard]] unsigned presses() const { return presses_; }
  [[nodiscard]] bool level() const { return gpio_.level(pin_.number); }

 private:
  PinPlace pin_;
  Gpio& gpio_;
  int pressed_level_;
  bool is_down_ = false;
  unsigned presses_ = 0;
};

using ButtonRow = Rows<ButtonElement>;

}  // namespace

Model button() {
  return {
      .type = "button",
      .summary = "a push button; released it leaves its pin alone",
      .figures = {required(row(Kind::pin, "pin", "", "")),
                  first_usual(choice("active", "level of the pin while it is pressed", {"low", "high"}))},
      .verbs = {ButtonRow::stimulus("press", "until it is released", {},
                                    [](ButtonElement& part, const Json&) { part.hold(true); }),
                ButtonRow::stimulus("release", "lets it go", {},
                                    [](ButtonElement& part, const Json&) { part.hold(false); })},
      .values = {ButtonRow::value("pressed", "", "1 or 0",
                                  [](ButtonElement& part) { return part.is_down() ? 1.0 : 0.0; }),
                 ButtonRow::value("level", "", "of its pin, 1 or 0",
                                  [](ButtonElement& part) { return part.level() ? 1.0 : 0.0; }),
                 ButtonRow::value("presses", "", "so far", [](ButtonElement& part) { return double(part.presses()); })},
      .make = ButtonRow::make,
  };
}

}  // namespace finemote::emulator
