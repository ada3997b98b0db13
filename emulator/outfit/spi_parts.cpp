// Parts on SPI buses.
#include "emulator/outfit/bodies.hpp"
#include "emulator/parts/bmi088.hpp"

namespace finemote::emulator {
namespace {

class Bmi088Element : public Element {
 public:
  Bmi088Element(Outfit& outfit, const Json& part, const std::string& name)
      : outfit_(outfit),
        seat_(part),
        model_([&outfit] { return outfit.now(); }, [this](Time now) { return seat_.motion(now); }) {
    const auto port = need<std::string>(part, "port");
    const bool placed =
        outfit.board().chip().attach_spi(port, need<unsigned>(part, "channel"), model_.accelerometer()) &&
        outfit.board().chip().attach_spi(port, need<unsigned>(part, "gyro"), model_.gyroscope());
    if (!placed) refuse(part, "the board has no such SPI port or chip select");
    model_.on_read = [this, name](Time from) {
      outfit_.record(PartEvent{name, PartEvent::Kind::sample, 0, to_ns(from), outfit_.board().now_ns(), 0});
    };
  }
  void connect(Outfit& outfit) override { seat_.connect(outfit); }
  bool happen(const std::string& what, const Json& event) override {
    if (what == "silent") return model_.silent = maybe(event, "on", true), true;
    if (what == "power_cycle") return model_.power_cycle(), true;
    if (what == "heat") return model_.temperature = need<double>(event, "temperature"), true;
    if (what == "move") return seat_.move(outfit_.now(), event), true;
    return false;
  }
  /// `roll` `pitch` `yaw` [deg] of where it sits, `temperature` [degrees Celsius].
  std::optional<double> value(const std::string& quantity) override {
    constexpr double kDegree = 0.017453292519943295;
    const Angles angles = angles_of(seat_.motion(outfit_.now()).attitude);
    if (quantity == "roll") return angles.roll / kDegree;
    if (quantity == "pitch") return angles.pitch / kDegree;
    if (quantity == "yaw") return angles.yaw / kDegree;
    if (quantity == "temperature") return model_.temperature;
    return std::nullopt;
  }

 private:
  Outfit& outfit_;
  Seat seat_;
  Bmi088 model_;
};

}  // namespace

std::unique_ptr<Element> make_bmi088(Outfit& outfit, const Json& part, const std::string& name) {
  return std::make_unique<Bmi088Element>(outfit, part, name);
}

}  // namespace finemote::emulator
