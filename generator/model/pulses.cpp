// Pulses and how often an output repeats them: FM3207 (a pulse that is not over when the next one is due), FM3209 (a
// device that changes the repetition of an output others share) and FM3017 (one that an expander cannot make).
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "generator/bus/bus_type.hpp"
#include "generator/diagnostic/code_hardware.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/offers.hpp"
#include "generator/model/reading.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

/// The `<param>` of a tag; null when it has none of the name.
const xml::Node* param_tag(const xml::Node& tag, const std::string& name) {
  for (const xml::Node& child : tag.children) {
    if (child.is_element("param") && value_of(child, "name") == name) return &child;
  }
  return nullptr;
}

/// An error at a param's value, or at the tag where the default counts.
Diagnostic& at_param(Diagnostics& diagnostics, Code code, const xml::Node& tag, const std::string& name,
                     std::string message) {
  const xml::Node* param = param_tag(tag, name);
  if (param == nullptr) return at_tag(diagnostics, code, tag, std::move(message));
  const TextAt text = element_text(*param);
  return diagnostics.error(code, text.at, std::move(message)).underline(text.text.size());
}

// -------------------------------------------------------------------------------------------------------------------
// how often an output repeats

/// Clock and frequency of an expander, as far as they are known.
struct Repeats {
  const RepeatSpec& spec;
  std::int64_t clock_hz, wanted_hz;

  [[nodiscard]] std::int64_t divider() const {
    const std::int64_t step = spec.counts * wanted_hz;
    return (clock_hz + step / 2) / step;
  }
  [[nodiscard]] bool is_made() const { return divider() >= spec.least_divider && divider() <= spec.most_divider; }
  /// Both fit 64 bits: counts and dividers are small, the clock is below 1 GHz.
  [[nodiscard]] Duration period() const { return floor_div(seconds(divider() * spec.counts), clock_hz); }
};

std::optional<Repeats> repeats_of(const Expander& expander) {
  if (expander.type == nullptr || !expander.type->repeats) return {};
  const RepeatSpec& spec = *expander.type->repeats;
  const auto hertz = [&](const std::string& name) { return param_value(expander.params, name, std::int64_t{0}); };
  const Repeats repeats{spec, hertz(spec.clock), hertz(spec.frequency)};
  if (repeats.clock_hz <= 0 || repeats.wanted_hz <= 0) return {};
  return repeats;
}

/// Time between two pulses on a segment; none where it is not known.
std::optional<Duration> repetition(const Reading& reading, const Segment& segment) {
  if (segment.kind == Segment::Kind::pwm_expander) {
    const auto repeats = repeats_of(reading.robot.expanders[*segment.expander]);
    return repeats && repeats->is_made() ? std::optional(repeats->period()) : std::nullopt;
  }
  if (bus_type(segment.bus_kind).channels != BusType::Channels::outputs) return {};
  const Port* port = reading.buses[segment.bus].port;
  return port != nullptr ? std::optional(port->period) : std::nullopt;
}

void check_frequency(Reading& reading, ExpanderId index) {
  const Expander& expander = reading.robot.expanders[index];
  const auto repeats = repeats_of(expander);
  if (!repeats || repeats->is_made()) return;
  const RepeatSpec& spec = repeats->spec;
  const ParamSpec* range = find_param(expander.params, spec.frequency)->spec;
  const auto frequency = [&](std::int64_t divider) { return repeats->clock_hz / (spec.counts * divider); };
  const auto least =
      std::max<std::int64_t>(frequency(spec.most_divider) + 1, static_cast<std::int64_t>(range->min.value_or(1)));
  const auto most =
      std::min<std::int64_t>(frequency(spec.least_divider), static_cast<std::int64_t>(range->max.value_or(1e9)));
  at_param(reading.diagnostics, code::rate_unreachable, *reading.tags.expanders[index], spec.frequency,
           fmt::format("expander '{}' cannot repeat pulses at {} Hz with its {} of {} Hz", expander.name.text,
                       repeats->wanted_hz, spec.clock, repeats->clock_hz))
      .hint(fmt::format("write a {} from {}Hz to {}Hz", spec.frequency, least, most));
}

// -------------------------------------------------------------------------------------------------------------------
// pulses

/// The longest pulse that the device's params ask for; null: its type has none.
const Param* longest_pulse(const Device& device) {
  const Param* longest = nullptr;
  const auto width = [](const Param& param) { return std::get<std::int64_t>(param.value); };
  for (const Param& param : device.params) {
    if (!param.spec->is_pulse || !std::holds_alternative<std::int64_t>(param.value)) continue;
    if (longest == nullptr || width(param) > width(*longest)) longest = &param;
  }
  return longest;
}

/// Of the usual frequencies, the highest at which the pulse is over a tenth of the time before the next one.
std::int64_t frequency_for(Duration pulse) {
  constexpr std::array<std::int64_t, 7> kUsual{400, 333, 250, 200, 100, 60, 50};
  const auto suits = [&](std::int64_t hz) { return pulse <= floor_div(milliseconds(900), hz); };
  const auto* found = std::find_if(kUsual.begin(), kUsual.end(), suits);
  return found == kUsual.end() ? kUsual.back() : *found;
}

std::string slower_output(const Reading& reading, const Segment& segment, Duration pulse) {
  if (segment.kind == Segment::Kind::pwm_expander) {
    const Expander& expander = reading.robot.expanders[*segment.expander];
    return fmt::format("write <param name=\"{}\">{}Hz</param> at expander '{}'", expander.type->repeats->frequency,
                       frequency_for(pulse), expander.name.text);
  }
  for (const std::string& name : free_ports(*reading.robot.board, used_ports(reading.robot), segment.bus_kind)) {
    if (reading.robot.board->port(name)->period > pulse)
      return fmt::format("write port=\"{}\" at bus '{}'", name, segment.name.text);
  }
  return {};
}

void check_pulse(Reading& reading, DeviceId index) {
  const Device& device = reading.robot.devices[index];
  const Param* param = longest_pulse(device);
  if (!device.segment || param == nullptr) return;
  const Segment& segment = reading.robot.segments[*device.segment];
  const auto period = repetition(reading, segment);
  const Duration pulse = nanoseconds(std::get<std::int64_t>(param->value));
  constexpr std::int64_t kCounts = 4096;  // an output needs at least one count of low level
  if (!period || pulse < *period - floor_div(*period, kCounts)) return;
  Diagnostic& finding =
      at_param(reading.diagnostics, code::pulse_period, reading.device_tag(index), param->spec->name,
               fmt::format("device '{}' sends pulses of up to {}, but '{}' repeats them every {}", device.name.text,
                           units::format_duration(pulse), segment.name.text, units::readable_duration(*period)));
  finding.note(fmt::format("{} '{}' is declared here", segment.expander ? "expander" : "bus", segment.name.text),
               segment.expander ? reading.robot.expanders[*segment.expander].at : reading.robot.buses[segment.bus].at);
  const std::string offer = slower_output(reading, segment, pulse);
  if (!offer.empty()) finding.hint(offer);
}

// -------------------------------------------------------------------------------------------------------------------
// outputs whose repetition a device changes

/// Another bus whose output repeats together with that of bus `index`.
const Bus* sharer(const Reading& reading, BusId index) {
  const Port* port = reading.buses[index].port;
  if (port == nullptr || port->timer_name().empty()) return nullptr;
  for (const BusId i : reading.robot.buses.ids()) {
    const Port* other = reading.buses[i].port;
    if (i != index && other != nullptr && other != port && other->timer_name() == port->timer_name())
      return &reading.robot.buses[i];
  }
  return nullptr;
}

/// A free port of the kind whose timer no bus uses, made for what the type provides if there is one.
/// Those that `offered` holds were offered already.
std::string port_alone(const Reading& reading, BusKind kind, const DeviceType& type,
                       const std::vector<std::string>& offered) {
  const Board& board = *reading.robot.board;
  const auto is_alone = [&](const Port& port) {
    return std::none_of(reading.buses.begin(), reading.buses.end(), [&](const Reading::BusState& bus) {
      return bus.port != nullptr && bus.port->timer_name() == port.timer_name();
    });
  };
  std::string found;
  for (const std::string& name : free_ports(board, used_ports(reading.robot), kind)) {
    const Port& port = *board.port(name);
    if (!is_alone(port) || std::find(offered.begin(), offered.end(), port.timer_name()) != offered.end()) continue;
    const bool is_made_for = !type.provides.empty() && port.drives == type.provides.front().name;
    if (is_made_for) return name;
    if (found.empty() && port.drives.empty()) found = name;
  }
  return found;
}

void check_tuning(Reading& reading, DeviceId index, std::vector<std::string>& offered) {
  const Device& device = reading.robot.devices[index];
  if (device.type == nullptr || !device.type->tunes || !device.segment) return;
  const Segment& segment = reading.robot.segments[*device.segment];
  const Bus* other = segment.kind == Segment::Kind::bus ? sharer(reading, segment.bus) : nullptr;
  if (segment.kind == Segment::Kind::bus && other == nullptr) return;
  const xml::Attribute* bus = reading.device_tag(index).attribute("bus");
  const std::string message =
      other == nullptr
          ? fmt::format("device '{}' sets how often its output repeats, but all channels of '{}' repeat together",
                        device.name.text, segment.name.text)
          : fmt::format("device '{}' sets how often its output repeats, but that of bus '{}' repeats with it",
                        device.name.text, other->name.text);
  Diagnostic& finding = at_value(reading.diagnostics, code::output_not_tunable, *bus, message);
  if (other != nullptr) {
    finding.note(fmt::format("ports '{}' and '{}' are channels of timer {}", reading.robot.buses[segment.bus].port,
                             other->port, reading.buses[segment.bus].port->timer_name()),
                 other->at);
  }
  const std::string port = port_alone(reading, segment.bus_kind, *device.type, offered);
  if (port.empty()) return;
  offered.push_back(reading.robot.board->port(port)->timer_name());

  finding.hint(fmt::format("put it on a bus of its own: <bus name=\"{}\" type=\"{}\" port=\"{}\"/>", port,
                           bus_kind_name(segment.bus_kind), port));
}

}  // namespace

void check_pulses(Reading& reading) {
  if (reading.robot.board == nullptr) return;
  for (const ExpanderId i : reading.robot.expanders.ids()) check_frequency(reading, i);
  std::vector<std::string> offered;
  for (const DeviceId i : reading.robot.devices.ids()) {
    check_pulse(reading, i);
    check_tuning(reading, i, offered);
  }
}

}  // namespace finemote::gen
