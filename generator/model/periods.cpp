// The period of a device as it is written, beside the tick. FM3036, FM3037, FM3079.
#include <fmt/format.h>

#include "generator/descriptor/runtime_limits.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/reading.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

class PeriodReader {
 public:
  PeriodReader(Reading& reading, const xml::Node& tag, Device& device, Reading::DeviceState& state)
      : reading_(reading), diagnostics_(reading.diagnostics), tag_(tag), device_(device), state_(state) {}

  void read() {
    const xml::Attribute* attribute = tag_.attribute("period");
    if (attribute == nullptr) {
      state_.period_is_wrong = reading_.tags.is_misspelt(tag_, "period");
      return;
    }
    device_.period_at = attribute->value_at;
    state_.period_is_wrong = true;
    const auto period = units::parse_duration(attribute->value);
    if (!period) {
      const units::Fault& fault = period.fault();
      auto& finding = at_value(diagnostics_, fault.code, *attribute, "period: " + fault.message);
      if (!fault.hint.empty()) finding.hint(in_ticks(fault.hint));
      return;
    }
    if (*period == Duration::zero()) {
      at_value(diagnostics_, code::period_zero, *attribute, fmt::format("the period of {} is zero", owner_))
          .hint("write for example period=\"10ms\"");
      return;
    }
    device_.period = *period;
    state_.period_is_wrong = false;
    check_tick(*attribute, *period);
    check_length(*attribute, *period);
  }

 private:
  void check_tick(const xml::Attribute& attribute, Duration period) {
    const Duration tick = reading_.robot.tick;
    if (!reading_.tick_is_known || is_multiple(period, tick)) return;
    const auto [below, above] = ticks_beside(period);
    at_value(diagnostics_, code::period_tick, attribute,
             fmt::format("the period of {} is not a multiple of the tick of {}", owner_, units::format_duration(tick)))
        .hint(below.empty() || above.empty() ? fmt::format("write period=\"{}\"", below + above)
                                             : fmt::format("write period=\"{}\" or period=\"{}\"", below, above));
  }
  /// The multiples of the tick below and above a period; empty when there is none.
  [[nodiscard]] std::pair<std::string, std::string> ticks_beside(Duration period) const {
    const Duration tick = reading_.robot.tick;
    const Duration below = round_down(period, tick);
    return {below > Duration::zero() ? units::format_duration(below) : "",
            period > Duration::max() - tick ? "" : units::format_duration(below + tick)};
  }
  /// A hint that offers a quantity (`write '2500us'; ...`), with multiples of the tick in its place.
  [[nodiscard]] std::string in_ticks(const std::string& hint) const {
    constexpr std::string_view kOffer = "write '";
    const std::size_t begin = hint.find(kOffer) + kOffer.size();
    const std::size_t end = hint.find('\'', begin);
    if (hint.find(kOffer) == std::string::npos || end == std::string::npos || !reading_.tick_is_known) return hint;
    const auto offered = units::parse_duration(std::string_view(hint).substr(begin, end - begin));
    if (!offered || is_multiple(*offered, reading_.robot.tick)) return hint;
    const auto [below, above] = ticks_beside(*offered);
    return fmt::format("write '{}{}{}'; the tick is {}", below, below.empty() ? "" : "' or '", above,
                       units::format_duration(reading_.robot.tick));
  }
  /// The scheduler counts the ticks of a period in 31 bits.
  void check_length(const xml::Attribute& attribute, Duration period) {
    const Duration tick = reading_.robot.tick;
    if (!reading_.tick_is_known || floor_div(period, tick) <= runtime_limits::kPeriodTicks) return;
    at_value(diagnostics_, code::period_too_long, attribute,
             fmt::format("the period of {} is longer than {} ticks of {}", owner_, runtime_limits::kPeriodTicks,
                         units::format_duration(tick)))
        .hint("write a shorter period");
  }

  Reading& reading_;
  Diagnostics& diagnostics_;
  const xml::Node& tag_;
  Device& device_;
  Reading::DeviceState& state_;
  std::string owner_ = fmt::format("device '{}'", device_.name.text);
};

}  // namespace

void read_period(Reading& reading, const xml::Node& tag, Device& device, Reading::DeviceState& state) {
  PeriodReader(reading, tag, device, state).read();
}

}  // namespace finemote::gen
