// A speed controller with its propeller.
#include <algorithm>
#include <cmath>

#include "emulator/outfit/bodies.hpp"
#include "emulator/outfit/figures.hpp"
#include "emulator/outfit/models.hpp"
#include "emulator/outfit/pwm_output.hpp"
#include "emulator/outfit/rows.hpp"
#include "emulator/scenario/figures.hpp"
#include "generator/diagnostic/code_scenario.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

/// The pulse's way from neutral is the share of full drive, whose square is the share of full thrust.
class ThrusterElement : public OutputElement {
 public:
  ThrusterElement(Outfit& outfit, const Json& part, const std::string& name)
      : OutputElement(outfit, part, name),
        part_(part),
        neutral_(need<double>(part, "neutral")),
        min_(need<double>(part, "min")),
        max_(need<double>(part, "max")),
        full_thrust_(need<double>(part, "full_thrust")),
        reverse_(maybe(part, "reverse", false)) {}
  void connect() override {
    if (!part_.contains("body")) return;
    auto* target = outfit().find<ThrustTarget>(need<std::string>(part_, "body"));
    if (target == nullptr) refuse(part_, "there is no such body");
    hull_ = &target->hull();
    number_ = hull_->add_thruster(vector(part_, "xyz"), vector(part_, "axis").normalized(), need<double>(part_, "lag"));
  }
  [[nodiscard]] double drive() const {
    if (pulse_ns() == 0) return 0;
    const double way = static_cast<double>(pulse_ns()) - neutral_;
    const double full = way > 0 ? max_ - neutral_ : neutral_ - min_;  // 0: it does not turn that way
    const double share = full > 0 ? std::clamp(way / full, -1.0, 1.0) : 0;
    return reverse_ ? -share : share;
  }
  [[nodiscard]] double thrust() const { return full_thrust_ * drive() * std::abs(drive()); }

 private:
  void changed() override {
    if (hull_ != nullptr) hull_->thrust(now(), number_, thrust());
  }

  Json part_;
  double neutral_, min_, max_;  ///< ns
  double full_thrust_;          ///< N
  bool reverse_;
  SubmergedBody* hull_ = nullptr;
  std::size_t number_ = 0;
};

using ThrusterRow = Rows<ThrusterElement>;

std::vector<Member> thruster_figures() {
  return {usually(1.5e6, positive("neutral", "ns", "")),
          usually(1.1e6, positive("min", "ns", "")),
          usually(1.9e6, positive("max", "ns", "")),
          flag("reverse", "turns the other way"),
          usually(20, number("full_thrust", "N", "", 0)),
          usually(0.05, number("lag", "s", "", 0, 60)),
          part("body", "hull", "it pushes"),
          vector3("xyz", "m", ""),
          usually({1, 0, 0}, vector3("axis", "", ""))};
}

void check_pulses(const gen::json::Value& entry, const Model& model, const scenario::World&,
                  gen::Diagnostics& diagnostics) {
  const auto neutral = figure(entry, model, "neutral"), min = figure(entry, model, "min"),
             max = figure(entry, model, "max");
  if (!neutral || !min || !max || (*min <= *neutral && *neutral <= *max)) return;
  const gen::json::Value* word = entry.find("neutral");
  if (word == nullptr) word = entry.find(*min > *neutral ? "min" : "max");
  diagnostics
      .error(gen::code::scenario_range, word->at,
             fmt::format("'neutral' must be between 'min', {} ns, and 'max', {} ns, got {} ns", *min, *max, *neutral))
      .underline(word->length);
}

std::vector<Quantity> thruster_values() {
  std::vector<Quantity> all = OutputElement::values();
  all.push_back(
      ThrusterRow::value("drive", "", "-1 to 1, along the axis", [](ThrusterElement& part) { return part.drive(); }));
  all.push_back(
      ThrusterRow::value("thrust", "N", "along the axis", [](ThrusterElement& part) { return part.thrust(); }));
  return all;
}

}  // namespace

Model thruster() {
  return {
      .type = "thruster",
      .summary = "converts pulses to thrust, quadratic in the drive with a lag of 50 ms; pushes a body",
      .figures = held_pulse_place("has") + thruster_figures(),
      .one_of = pulse_where(),
      .values = thruster_values(),
      .make = ThrusterRow::make,
      .check = check_pulses,
  };
}

}  // namespace finemote::emulator
