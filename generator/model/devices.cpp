// The <device> elements, each by itself: type, bus, period as written, params, wcet, uses. FM3019 to FM3022, FM3036,
// FM3037, FM3070 to FM3073, FM3075.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "generator/descriptor/bus_kind.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/descriptor/runtime_limits.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/names.hpp"
#include "generator/model/no_segment.hpp"
#include "generator/model/offers.hpp"
#include "generator/model/pins.hpp"
#include "generator/model/reading.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

bool contains(const std::vector<BusKind>& kinds, BusKind kind) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

std::vector<std::string> names_of(const std::vector<UseSpec>& uses) {
  std::vector<std::string> names;
  for (const UseSpec& use : uses) names.push_back(use.role);
  return names;
}

/// Names of the buses of certain kinds, for hints.
std::vector<std::string> segments_of(const Reading& reading, const std::vector<BusKind>& kinds) {
  std::vector<std::string> names;
  for (const Segment& segment : reading.robot.segments) {
    if (contains(kinds, segment.bus_kind)) names.push_back(segment.name.text);
  }
  return names;
}

bool kind_is_known(const Reading& reading, const Segment& segment) {
  return segment.kind != Segment::Kind::bus || reading.buses[segment.bus].kind_is_known;
}

class DeviceReader {
 public:
  DeviceReader(Reading& reading, const xml::Node& tag)
      : reading_(reading), diagnostics_(reading.diagnostics), tag_(tag) {}

  void read() {
    device_.name = make_name(value_of(tag_, "name"));
    device_.at = device_.period_at = tag_.at;
    owner_ = fmt::format("device '{}'", device_.name.text);
    read_type();
    read_bus();
    read_period();
    device_.link = value_of(tag_, "link");
    device_.joint = value_of(tag_, "joint");
    if (device_.type != nullptr) {
      device_.params = read_param_tags(reading_, tag_, device_.type->params, owner_);
      read_uses();
    }
    read_wcet();
    reading_.robot.devices.push_back(std::move(device_));
    reading_.devices.push_back(state_);
  }

 private:
  void read_type() {
    const xml::Attribute* type = tag_.attribute("type");
    if (type == nullptr) return;
    const std::vector<std::string> known = device_type_names(reading_.library);
    if (std::find(known.begin(), known.end(), type->value) == known.end()) {
      auto& finding = at_value(diagnostics_, code::unknown_device_type, *type,
                               fmt::format("there is no device type '{}'", type->value));
      suggest(finding, type->value, known);
      finding.note(
          "types of your own are descriptors in a folder 'devices' beside the input, or in one given by --device-path");
      return;
    }
    device_.type = find_device_type(reading_.library, type->value, reading_.sources, diagnostics_);
  }

  void read_bus() {
    const xml::Attribute* bus = tag_.attribute("bus");
    if (bus == nullptr) {
      if (device_.type != nullptr && device_.type->bus_required && !device_.type->buses.empty()) report_no_bus();
      return;
    }
    const auto segment = reading_.segment_named(bus->value);
    state_.bus_is_wrong = true;
    if (!segment) {
      const bool fits_some = device_.type != nullptr && !device_.type->buses.empty();
      reading_.report_unknown_bus(*bus,
                                  fits_some ? segments_of(reading_, device_.type->buses) : reading_.segment_names());
      return;
    }
    if (device_.type == nullptr || !sits_on(*bus, reading_.robot.segments[*segment])) return;
    state_.bus_is_wrong = false;
    device_.segment = segment;
    check_bus_speed(*bus, reading_.robot.segments[*segment]);
  }
  void report_no_bus() {
    state_.bus_is_wrong = true;
    if (reading_.tags.is_misspelt(tag_, "bus")) return;
    auto& finding = at_tag(diagnostics_, code::bus_needed, tag_,
                           fmt::format("{} of type '{}' needs a bus", owner_, device_.type->name));
    finding.note(fmt::format("it sits on {}", fmt::join(bus_kind_names(device_.type->buses), ", ")));
    const auto candidates = segments_of(reading_, device_.type->buses);
    if (!candidates.empty()) finding.hint(fmt::format("add for example bus=\"{}\"", candidates.front()));
  }
  bool sits_on(const xml::Attribute& bus, const Segment& segment) {
    const DeviceType& type = *device_.type;
    if (type.buses.empty()) {
      at_value(diagnostics_, code::bus_kind, bus, fmt::format("'{}' does not use a bus", type.name))
          .hint("remove bus=\"" + bus.value + "\"");
      return false;
    }
    if (!kind_is_known(reading_, segment) || contains(type.buses, segment.bus_kind))
      return kind_is_known(reading_, segment) && segment.bus != kNoBus;
    auto& finding =
        at_value(diagnostics_, code::bus_kind, bus,
                 fmt::format("'{}' sits on {}; bus '{}' is of type '{}'", type.name,
                             fmt::join(bus_kind_names(type.buses), ", "), bus.value, bus_kind_name(segment.bus_kind)));
    const auto candidates = segments_of(reading_, type.buses);
    if (!candidates.empty()) suggest(finding, bus.value, candidates);
    if (candidates.empty())
      finding.hint(fmt::format("add a bus of that kind: <bus name=\"...\" type=\"{}\" port=\"...\"/>",
                               bus_kind_name(type.buses.front())));
    return false;
  }
  /// A clock of at most `most` that the bus's port makes, as the bus would write it.
  std::string slower_clock(const Segment& segment, std::int64_t most) {
    const Port* port = reading_.buses[segment.bus].port;
    const std::string clock = fastest_clock(port, segment.bus_kind, most);
    if (!clock.empty()) return fmt::format("write clock=\"{}\" at the bus", clock);
    return fmt::format("port '{}' makes no clock that slow: choose another port", port->name);
  }

  /// The bus may not be faster than the part, and a serial line has to run at one of its rates.
  void check_bus_speed(const xml::Attribute& bus, const Segment& segment) {
    if (segment.kind == Segment::Kind::pwm_expander || !reading_.buses[segment.bus].rate_is_known) return;
    const Bus& physical = reading_.robot.buses[segment.bus];
    const DeviceType& type = *device_.type;
    if (type.max_clock_hz && physical.rate > *type.max_clock_hz) {
      at_value(diagnostics_, code::rate_unreachable, bus,
               fmt::format("bus '{}' runs at {} Hz, but '{}' supports at most {} Hz", physical.name.text, physical.rate,
                           type.name, *type.max_clock_hz))
          .note("the bus is declared here", physical.at)
          .hint(slower_clock(segment, *type.max_clock_hz));
    }
    if (type.rates.empty() || std::find(type.rates.begin(), type.rates.end(), physical.rate) != type.rates.end())
      return;
    std::string rates;
    for (const std::int64_t rate : type.rates) rates += fmt::format("{}{}", rates.empty() ? "" : ", ", rate);
    const std::int64_t fastest = *std::max_element(type.rates.begin(), type.rates.end());
    at_value(diagnostics_, code::rate_unreachable, bus,
             fmt::format("bus '{}' runs at {} bit/s, which '{}' does not support", physical.name.text, physical.rate,
                         type.name))
        .note("the bus is declared here", physical.at)
        .hint(fmt::format("write {}=\"{}\" at the bus{}", rate_attribute(segment.bus_kind),
                          rate_text(segment.bus_kind, fastest),
                          type.rates.size() > 1 ? fmt::format("; the part can run at {} bit/s", rates) : ""));
  }

  void read_period() {
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
    if (*period == 0) {
      at_value(diagnostics_, code::period_zero, *attribute, fmt::format("the period of {} is zero", owner_))
          .hint("write for example period=\"10ms\"");
      return;
    }
    device_.period_ns = *period;
    state_.period_is_wrong = false;
    check_tick(*attribute, *period);
    check_length(*attribute, *period);
  }
  void check_tick(const xml::Attribute& attribute, std::int64_t period) {
    const std::int64_t tick = reading_.robot.tick_ns;
    if (!reading_.tick_is_known || period % tick == 0) return;
    const auto [below, above] = ticks_beside(period);
    at_value(diagnostics_, code::period_tick, attribute,
             fmt::format("the period of {} is not a multiple of the tick of {}", owner_, units::format_duration(tick)))
        .hint(below.empty() ? fmt::format("write period=\"{}\"", above)
                            : fmt::format("write period=\"{}\" or period=\"{}\"", below, above));
  }
  /// The multiples of the tick below and above a period; empty when there is none.
  [[nodiscard]] std::pair<std::string, std::string> ticks_beside(std::int64_t period) const {
    const std::int64_t tick = reading_.robot.tick_ns;
    const std::int64_t below = period / tick * tick;
    return {below > 0 ? units::format_duration(below) : "",
            period > INT64_MAX - tick ? "" : units::format_duration(below + tick)};
  }
  /// A hint that offers a quantity (`write '2500us'; ...`), with multiples of the tick in its place.
  [[nodiscard]] std::string in_ticks(const std::string& hint) const {
    constexpr std::string_view kOffer = "write '";
    const std::size_t begin = hint.find(kOffer) + kOffer.size();
    const std::size_t end = hint.find('\'', begin);
    if (hint.find(kOffer) == std::string::npos || end == std::string::npos || !reading_.tick_is_known) return hint;
    const auto offered = units::parse_duration(std::string_view(hint).substr(begin, end - begin));
    if (!offered || *offered % reading_.robot.tick_ns == 0) return hint;
    const auto [below, above] = ticks_beside(*offered);
    return fmt::format("write '{}{}{}'; the tick is {}", below, below.empty() ? "" : "' or '", above,
                       units::format_duration(reading_.robot.tick_ns));
  }
  /// The scheduler counts the ticks of a period in 31 bits.
  void check_length(const xml::Attribute& attribute, std::int64_t period) {
    const std::int64_t tick = reading_.robot.tick_ns;
    if (!reading_.tick_is_known || period / tick <= runtime_limits::kPeriodTicks) return;
    at_value(diagnostics_, code::period_too_long, attribute,
             fmt::format("the period of {} is longer than {} ticks of {}", owner_, runtime_limits::kPeriodTicks,
                         units::format_duration(tick)))
        .hint("write a shorter period");
  }

  void read_uses() {
    std::set<std::string> given;
    for (const xml::Node& child : tag_.children) {
      if (!child.is_element("use")) continue;
      const xml::Attribute* role = child.attribute("role");
      if (role != nullptr) read_use(child, *role, given);
    }
    for (const UseSpec& spec : device_.type->uses) {
      if (!spec.required || given.count(spec.role) > 0) continue;
      at_tag(diagnostics_, code::use_missing, tag_, fmt::format("{} needs <use role=\"{}\">", owner_, spec.role))
          .note(fmt::format("it takes: {}", fmt::join(bus_kind_names(spec.buses), ", ")))
          .hint(fmt::format("add for example <use role=\"{}\" {}/>", spec.role,
                            contains(spec.buses, BusKind::gpio) ? "pin=\"" + example_pin(spec) + "\"" : "bus=\"...\""));
    }
  }
  /// The line that the board wires to the part whose data-ready line the use is; null: the board has no such part.
  [[nodiscard]] const NamedPin* wired_line(const UseSpec& spec) const {
    if (reading_.robot.board == nullptr || spec.data_ready_of.empty()) return nullptr;
    const xml::Node* place = &tag_;
    if (spec.data_ready_of != kDeviceItself) {
      const auto selects = [&](const xml::Node& child) {
        return child.is_element("use") && value_of(child, "role") == spec.data_ready_of;
      };
      const auto found = std::find_if(tag_.children.begin(), tag_.children.end(), selects);
      if (found == tag_.children.end()) return nullptr;
      place = &*found;
    }
    const auto segment = reading_.segment_named(value_of(*place, "bus"));
    if (!segment || reading_.robot.segments[*segment].kind != Segment::Kind::bus) return nullptr;
    const auto channel = units::parse_bare(value_of(*place, "channel"));
    return data_ready_line(*reading_.robot.board, reading_.robot.buses[reading_.robot.segments[*segment].bus].port,
                           channel ? std::optional<std::uint32_t>(*channel) : std::nullopt);
  }
  /// A pin of the board wired for the use, by its name.
  [[nodiscard]] std::string example_pin(const UseSpec& spec) const {
    if (const NamedPin* wired = wired_line(spec)) return wired->name;
    const std::string& function = spec.function;
    if (reading_.robot.board != nullptr) {
      for (const NamedPin& pin : reading_.robot.board->pins) {
        if (pin.can(function)) return pin.name;
      }
    }
    return "PB12";
  }
  void read_use(const xml::Node& child, const xml::Attribute& role, std::set<std::string>& given) {
    const auto& specs = device_.type->uses;
    const auto spec = std::find_if(specs.begin(), specs.end(),
                                   [&](const UseSpec& candidate) { return candidate.role == role.value; });
    if (spec == specs.end()) {
      auto& finding = at_value(diagnostics_, code::unknown_use, role,
                               fmt::format("'{}' uses no '{}'", device_.type->name, role.value));
      suggest(finding, role.value, names_of(specs));
      if (specs.empty()) finding.note("this type uses no further hardware").hint("remove the <use>");
      return;
    }
    if (!given.insert(role.value).second) {
      at_value(diagnostics_, code::element_twice, role,
               fmt::format("{} has two <use role=\"{}\">", owner_, role.value));
      return;
    }
    Use use;
    use.spec = &*spec;
    use.at = child.at;
    use.channel = read_quantity(child, "channel", units::parse_bare, diagnostics_);
    if (read_endpoint(child, use)) device_.uses.push_back(std::move(use));
  }
  bool read_endpoint(const xml::Node& child, Use& use) {
    const xml::Attribute* bus = child.attribute("bus");
    const xml::Attribute* pin = child.attribute("pin");
    const bool wants_pin = contains(use.spec->buses, BusKind::gpio);
    const bool wants_bus = use.spec->buses.size() > (wants_pin ? 1U : 0U);
    if (bus != nullptr && pin != nullptr) {
      at_tag(diagnostics_, code::use_endpoint, child,
             fmt::format("<use role=\"{}\"> names a bus and a pin", use.spec->role))
          .hint(!wants_bus   ? fmt::format("remove bus=\"{}\"", bus->value)
                : !wants_pin ? fmt::format("remove pin=\"{}\"", pin->value)
                             : "remove one of them");
      return false;
    }
    if (bus == nullptr && pin == nullptr) {
      const std::string what = wants_pin && wants_bus ? "either 'bus' or 'pin'" : wants_pin ? "a 'pin'" : "a 'bus'";
      at_tag(diagnostics_, code::use_endpoint, child,
             fmt::format("<use role=\"{}\"> has to name {}", use.spec->role, what))
          .hint(fmt::format("write <use role=\"{}\" {}/>", use.spec->role,
                            wants_bus ? "bus=\"...\"" : "pin=\"" + example_pin(*use.spec) + "\""));
      return false;
    }
    if (pin != nullptr) return read_pin(*pin, use, wants_pin);
    return read_use_bus(*bus, use);
  }
  bool read_pin(const xml::Attribute& pin, Use& use, bool wants_pin) {
    if (!wants_pin) {
      at_value(diagnostics_, code::use_endpoint, pin,
               fmt::format("<use role=\"{}\"> takes a {}, not a pin", use.spec->role,
                           fmt::join(bus_kind_names(use.spec->buses), ", ")));
      return false;
    }
    const PlacedPin found =
        find_pin(reading_.robot.board, pin.value, pin.value_at, fmt::format("<use role=\"{}\">", use.spec->role),
                 {use.spec->function, wired_line(*use.spec)}, diagnostics_);
    use.pin = found.pin;
    use.named = found.named;
    return !found.pin.empty();
  }
  bool read_use_bus(const xml::Attribute& bus, Use& use) {
    use.segment = reading_.segment_named(bus.value);
    if (!use.segment) {
      reading_.report_unknown_bus(bus, segments_of(reading_, use.spec->buses));
      return false;
    }
    const Segment& segment = reading_.robot.segments[*use.segment];
    if (!kind_is_known(reading_, segment)) return false;
    if (contains(use.spec->buses, segment.bus_kind)) return segment.bus != kNoBus;
    at_value(diagnostics_, code::bus_kind, bus,
             fmt::format("<use role=\"{}\"> takes {}; bus '{}' is of type '{}'", use.spec->role,
                         fmt::join(bus_kind_names(use.spec->buses), ", "), bus.value, bus_kind_name(segment.bus_kind)));
    return false;
  }

  void read_wcet() {
    const xml::Node* wcet = nullptr;
    for (const xml::Node& child : tag_.children) {
      if (!child.is_element("wcet")) continue;
      if (wcet != nullptr) {
        at_tag(diagnostics_, code::element_twice, child, fmt::format("{} has two <wcet>", owner_))
            .note("the first one is declared here", wcet->at);
      } else {
        wcet = &child;
      }
    }
    if (wcet == nullptr) return;
    device_.wcet.update_ns = read_duration_in(*wcet, "update", "us", diagnostics_).value_or(0);
    device_.wcet.handle_ns = read_duration_in(*wcet, "handle", "us", diagnostics_).value_or(0);
    const auto source = read_choice(*wcet, "source", {"budget", "measured", "static"}, diagnostics_).value_or("budget");
    device_.wcet.source = source == "measured" ? Wcet::Source::measured
                          : source == "static" ? Wcet::Source::static_analysis
                                               : Wcet::Source::budget;
  }

  Reading& reading_;
  Diagnostics& diagnostics_;
  const xml::Node& tag_;
  std::string owner_;
  Device device_;
  Reading::DeviceState state_;
};

}  // namespace

void read_devices(Reading& reading) {
  for (const DeviceTag& tag : reading.tags.devices) DeviceReader(reading, *tag.node).read();
}

}  // namespace finemote::gen
