// The <device> elements, each by itself: type, bus, params, wcet; periods and uses have files of their own. FM3019 to
// FM3022, FM3017, FM3075.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "generator/bus/bus_kind.hpp"
#include "generator/bus/rate_form.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/names.hpp"
#include "generator/model/no_segment.hpp"
#include "generator/model/offers.hpp"
#include "generator/model/reading.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {

bool contains(const std::vector<BusKind>& kinds, BusKind kind) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

namespace {

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
    read_period(reading_, tag_, device_, state_);
    device_.link = value_of(tag_, "link");
    device_.joint = value_of(tag_, "joint");
    if (device_.type != nullptr) {
      device_.params = read_param_tags(reading_, tag_, device_.type->params, owner_);
      read_uses(reading_, tag_, device_);
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
                                  fits_some ? reading_.segment_names(device_.type->buses) : reading_.segment_names());
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
    finding.note(fmt::format("it sits on {}", fmt::join(bus_kind_names(device_.type->buses), " or ")));
    const auto candidates = reading_.segment_names(device_.type->buses);
    if (!candidates.empty()) finding.hint(fmt::format("add for example bus=\"{}\"", candidates.front()));
  }
  bool sits_on(const xml::Attribute& bus, const Segment& segment) {
    const DeviceType& type = *device_.type;
    if (type.buses.empty()) {
      at_value(diagnostics_, code::bus_kind, bus, fmt::format("'{}' does not use a bus", type.name))
          .hint("remove bus=\"" + bus.value + "\"");
      return false;
    }
    if (!reading_.kind_is_known(segment) || contains(type.buses, segment.bus_kind))
      return reading_.kind_is_known(segment) && segment.bus != kNoBus;
    auto& finding = at_value(
        diagnostics_, code::bus_kind, bus,
        fmt::format("'{}' sits on {}; bus '{}' is of type '{}'", type.name,
                    fmt::join(bus_kind_names(type.buses), " or "), bus.value, bus_kind_name(segment.bus_kind)));
    const auto candidates = reading_.segment_names(type.buses);
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
    device_.wcet.update = read_duration_in(*wcet, "update", "us", diagnostics_).value_or(Duration::zero());
    device_.wcet.handle = read_duration_in(*wcet, "handle", "us", diagnostics_).value_or(Duration::zero());
    device_.wcet.source = read_source(*wcet);
  }

  Wcet::Source read_source(const xml::Node& wcet) {
    constexpr std::array kSources{Wcet::Source::budget, Wcet::Source::measured, Wcet::Source::static_analysis};
    std::vector<std::string> names;
    for (const Wcet::Source source : kSources) names.emplace_back(to_string(source));
    const auto name = read_choice(wcet, "source", names, diagnostics_);
    const auto found = std::find(names.begin(), names.end(), name.value_or(names.front()));
    return kSources.at(static_cast<std::size_t>(found - names.begin()));
  }

  Reading& reading_;
  Diagnostics& diagnostics_;
  const xml::Node& tag_;
  std::string owner_;
  Device device_;
  Reading::DeviceState state_;
};

}  // namespace

const char* to_string(Wcet::Source source) {
  switch (source) {
    case Wcet::Source::assumed:
      return "assumed";
    case Wcet::Source::budget:
      return "budget";
    case Wcet::Source::measured:
      return "measured";
    case Wcet::Source::static_analysis:
      return "static";
    case Wcet::Source::computed:
      break;
  }
  return "computed";
}

void read_devices(Reading& reading) {
  for (const DeviceTag& tag : reading.tags.devices) DeviceReader(reading, *tag.node).read();
}

}  // namespace finemote::gen
