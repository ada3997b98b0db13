// What hangs on PWM outputs.
#include <algorithm>
#include <cmath>

#include "emulator/outfit/bodies.hpp"

namespace finemote::emulator {
namespace {

/// An output whose pulse is looked at, of a header of the board.
class OutputElement : public Element {
 public:
  OutputElement(Outfit& outfit, const Json& part, const std::string& name) {
    outfit.listen_to_pulses(part, [this](Timer::Pulse pulse) {
      if (pulse_ == 0) resumed_with_ = pulse.width_ns;
      pulse_ = pulse.width_ns;
      changed();
    });
    show("pulse", [this] { return static_cast<double>(pulse_) / 1000; });
    show("resumed_with", [this] { return static_cast<double>(resumed_with_) / 1000; });
    if (!part.contains("port")) return;  // an expander records its outputs itself
    outfit.listen_to_writes(part, [&outfit, name](std::uint64_t width_ns) {
      const std::uint64_t now = outfit.board().now_ns();
      outfit.record(PartEvent{name, PartEvent::Kind::output, 0, now, now, static_cast<double>(width_ns)});
    });
  }

 protected:
  virtual void changed() {}
  std::uint64_t pulse_ = 0, resumed_with_ = 0;
};

/// A speed controller with its propeller: the pulse's way from neutral is the share of full drive, whose square is the
/// share of full thrust.
class ThrusterElement : public OutputElement {
 public:
  ThrusterElement(Outfit& outfit, const Json& part, const std::string& name)
      : OutputElement(outfit, part, name), outfit_(outfit), part_(part) {
    neutral_ = maybe(part, "neutral", neutral_);
    min_ = maybe(part, "min", min_);
    max_ = maybe(part, "max", max_);
    full_thrust_ = maybe(part, "full_thrust", full_thrust_);
    reverse_ = maybe(part, "reverse", reverse_);
    show("drive", [this] { return drive(); });
    show("thrust", [this] { return thrust(); });
    if (min_ > neutral_ || max_ < neutral_) refuse(part, "'neutral' lies between 'min' and 'max'");
  }
  void connect(Outfit& outfit) override {
    if (!part_.contains("body")) return;
    auto* target = outfit.find<ThrustTarget>(need<std::string>(part_, "body"));
    if (target == nullptr) refuse(part_, "there is no such body");
    hull_ = &target->hull();
    number_ = hull_->add_thruster(vector(part_, "xyz"), vector(part_, "axis", {1, 0, 0}).normalized(),
                                  maybe(part_, "lag", 0.05));
  }

 private:
  [[nodiscard]] double drive() const {
    if (pulse_ == 0) return 0;
    const double way = static_cast<double>(pulse_) - neutral_;
    const double full = way > 0 ? max_ - neutral_ : neutral_ - min_;  // 0: it does not turn that way
    const double share = full > 0 ? std::clamp(way / full, -1.0, 1.0) : 0;
    return reverse_ ? -share : share;
  }
  [[nodiscard]] double thrust() const { return full_thrust_ * drive() * std::abs(drive()); }
  void changed() override {
    if (hull_ != nullptr) hull_->thrust(outfit_.now(), number_, thrust());
  }

  Outfit& outfit_;
  Json part_;
  double neutral_ = 1'500'000, min_ = 1'100'000, max_ = 1'900'000;  ///< ns
  double full_thrust_ = 20;                                         ///< N
  bool reverse_ = false;
  SubmergedBody* hull_ = nullptr;
  std::size_t number_ = 0;
};

}  // namespace

std::unique_ptr<Element> make_pwm_output(Outfit& outfit, const Json& part, const std::string& name) {
  return std::make_unique<OutputElement>(outfit, part, name);
}
std::unique_ptr<Element> make_thruster(Outfit& outfit, const Json& part, const std::string& name) {
  return std::make_unique<ThrusterElement>(outfit, part, name);
}

}  // namespace finemote::emulator
