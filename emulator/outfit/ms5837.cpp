// MS5837: pressure under water.
#include "emulator/parts/ms5837.hpp"

#include "emulator/outfit/figures.hpp"
#include "emulator/outfit/models.hpp"
#include "emulator/outfit/rows.hpp"
#include "emulator/outfit/seat.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

constexpr double kSurfacePascal = 101'325, kWaterDensity = 1000;

class PressureElement : public SeatedElement {
 public:
  PressureElement(Outfit& outfit, const Json& part, const std::string& name)
      : SeatedElement(outfit, part, name),
        model(
            need<std::string>(part, "variant") == "02BA" ? Ms5837::Variant::k02BA : Ms5837::Variant::k30BA,
            [&outfit] { return outfit.now(); }, [this](Time at) { return pressure(at); }),
        follows_(part.contains("body")),
        pressure_(need<double>(part, "pressure")) {
    model.on_sample = [this](Time at) { return record_sample(at, at); };
    outfit.line_of(part).attach(model);
  }
  double pressure(Time at) {
    if (!follows_) return pressure_;
    const double depth = -motion(at).position.z();
    return kSurfacePascal + (depth > 0 ? depth * kWaterDensity * kGravity : 0);
  }
  double pressure() { return pressure(now()); }
  void move_to(double pressure) {
    pressure_ = pressure;
    follows_ = false;
  }

  Ms5837 model;

 private:
  bool follows_;
  double pressure_;
};

void silence(PressureElement& part, const Json& event) { part.model.dead = is_on(event); }

void damage(PressureElement& part, const Json& event) { part.model.prom_damage = need<std::uint16_t>(event, "bits"); }

void move(PressureElement& part, const Json& event) { part.move_to(need<double>(event, "pressure")); }

Member fixed_address() {
  Member member = address(Ms5837::kAddress);
  member.summary = "7 bits; it can have no other";
  member.min = member.max = Ms5837::kAddress;
  return member;
}

}  // namespace

Model ms5837() {
  using Row = Rows<PressureElement>;
  return {
      .type = "ms5837",
      .summary = "conversions with their real duration; pressure from depth",
      .figures = i2c_place() + std::vector{fixed_address()} + seat() +
                 std::vector{first_usual(choice("variant", "", {"30BA", "02BA"})),
                             usually(kSurfacePascal, number("pressure", "Pa", "without a body", 0, 1e8))},
      .one_of = i2c_where(),
      .verbs = {Row::fault("silent", "does not answer", {until()}, silence),
                Row::fault("damage", "corrupts its PROM",
                           {required(integer("bits", "", "mask of the bits that flip", 1, 65535))}, damage),
                Row::stimulus("move", "to where there is this pressure; it no longer follows its body",
                              {required(number("pressure", "Pa", "", 0, 1e8))}, move)},
      .values = {Row::value("pressure", "Pa", "", [](PressureElement& part) { return part.pressure(); }),
                 Row::value("conversions", "", "so far",
                            [](PressureElement& part) -> double { return part.model.conversions(); })},
      .make = Row::make,
  };
}

}  // namespace finemote::emulator
