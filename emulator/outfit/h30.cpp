// H30 inertial unit.
#include "emulator/parts/h30.hpp"

#include <numbers>

#include "emulator/outfit/figures.hpp"
#include "emulator/outfit/models.hpp"
#include "emulator/outfit/rows.hpp"
#include "emulator/outfit/seat.hpp"
#include "emulator/outfit/serial_line.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

class H30Element : public SeatedElement {
 public:
  H30Element(Outfit& outfit, const Json& part, const std::string& name)
      : SeatedElement(outfit, part, name),
        model(outfit.board().world(), outfit.usart_of(part), format_of(part), period_of(part), phase_of(part),
              [this](Time at) { return feel(at); }) {
    model.on_frame = [this](Time begin, Time end) { return record_sample(begin, end); };
  }

  H30 model;

 private:
  Attitude feel(Time at) {
    const Motion felt = motion(at);
    const Angles angles = angles_of(felt.attitude);
    constexpr double kDegree = std::numbers::pi / 180;
    Attitude attitude;
    attitude.roll = angles.roll / kDegree;
    attitude.pitch = angles.pitch / kDegree;
    attitude.yaw = angles.yaw / kDegree;
    for (unsigned i = 0; i < 3; ++i) {
      attitude.rate[i] = felt.rate[i] / kDegree;
      attitude.acceleration[i] = felt.force[i];
    }
    return attitude;
  }
};

void silence(H30Element& part, const Json& event) { part.model.silent = is_on(event); }

void damage(H30Element& part, const Json& event) { part.model.damaged_frames = need<unsigned>(event, "frames"); }

}  // namespace

Model h30_imu() {
  using Row = Rows<H30Element>;
  return {
      .type = "h30_imu",
      .summary = "frames of attitude, rates and acceleration every `period_ns`",
      .figures = serial_line() + pace(5e6) + seat(),
      .clock_tolerance_ppm = kResonatorTolerancePpm,
      .verbs = {Row::fault("silent", "sends nothing", {until()}, silence),
                Row::fault("damage", "frames with a wrong checksum", {count("frames")}, damage),
                SeatedElement::move_verb()},
      .values = {Row::value("frames", "", "sent so far",
                            [](H30Element& part) -> double { return part.model.frames(); })},
      .make = Row::make,
  };
}

}  // namespace finemote::emulator
