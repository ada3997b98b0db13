#include "emulator/outfit/pwm_output.hpp"

#include "emulator/outfit/figures.hpp"
#include "emulator/outfit/models.hpp"
#include "emulator/outfit/rows.hpp"

namespace finemote::emulator {

using namespace scenario;

OutputElement::OutputElement(Outfit& outfit, const Json& part, const std::string& name) : Element(outfit, name) {
  outfit.listen_to_pulses(part, [this](Timer::Pulse pulse) {
    if (pulse_ == 0) resumed_with_ = pulse.width_ns;
    pulse_ = pulse.width_ns;
    changed();
  });
  if (!part.contains("port")) return;  // an expander records its outputs itself
  outfit.listen_to_writes(
      part, [this](std::uint64_t width_ns, Tag origin) { record_output(0, static_cast<double>(width_ns), origin); });
}

std::vector<Quantity> OutputElement::values() {
  using Row = Rows<OutputElement>;
  return {Row::value("pulse", "us", "", [](OutputElement& part) { return part.pulse_us(); }),
          Row::value("resumed_with", "us", "the first pulse after the output was off",
                     [](OutputElement& part) { return part.resumed_with_us(); })};
}

Model pwm_output() {
  return {
      .type = "pwm_output",
      .summary = "a pulse to observe",
      .figures = held_pulse_place("observes"),
      .one_of = pulse_where(),
      .values = OutputElement::values(),
      .make = Rows<OutputElement>::make,
  };
}

}  // namespace finemote::emulator
