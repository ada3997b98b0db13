// The <use> elements of a device: further buses and pins. FM3019, FM3020, FM3022, FM3070 to FM3073.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "generator/bus/bus_type.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/no_segment.hpp"
#include "generator/model/pins.hpp"
#include "generator/model/reading.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

std::vector<std::string> names_of(const std::vector<UseSpec>& uses) {
  std::vector<std::string> names;
  for (const UseSpec& use : uses) names.push_back(use.role);
  return names;
}

bool takes_pin(const UseSpec& use) {
  return std::any_of(use.buses.begin(), use.buses.end(),
                     [](BusKind kind) { return bus_type(kind).channels == BusType::Channels::pins; });
}

class UseReader {
 public:
  UseReader(Reading& reading, const xml::Node& tag, Device& device)
      : reading_(reading), diagnostics_(reading.diagnostics), tag_(tag), device_(device) {}

  void read() {
    std::set<std::string> given;
    for (const xml::Node& child : tag_.children) {
      if (!child.is_element("use")) continue;
      const xml::Attribute* role = child.attribute("role");
      if (role != nullptr) read_use(child, *role, given);
    }
    for (const UseSpec& spec : device_.type->uses) {
      if (!spec.required || given.count(spec.role) > 0) continue;
      at_tag(diagnostics_, code::use_missing, tag_, fmt::format("{} needs <use role=\"{}\">", owner_, spec.role))
          .note(fmt::format("it takes: {}", fmt::join(bus_kind_names(spec.buses), " or ")))
          .hint(fmt::format("add for example <use role=\"{}\" {}/>", spec.role,
                            takes_pin(spec) ? "pin=\"" + example_pin(spec) + "\"" : example_bus(spec)));
    }
  }

 private:
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
  /// A further chip select is on the device's own bus.
  [[nodiscard]] std::string example_bus(const UseSpec& spec) const {
    const std::string own(value_of(tag_, "bus"));
    const auto segment = reading_.segment_named(own);
    const auto is_shared = [&](BusKind kind) {
      return bus_type(kind).channels == BusType::Channels::selects && contains(spec.buses, kind);
    };
    return segment && is_shared(reading_.robot.segments[*segment].bus_kind)
               ? fmt::format("bus=\"{}\" channel=\"...\"", own)
               : "bus=\"...\"";
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
    const bool wants_pin = takes_pin(*use.spec);
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
                            wants_bus ? example_bus(*use.spec) : "pin=\"" + example_pin(*use.spec) + "\""));
      return false;
    }
    if (pin != nullptr) return read_pin(*pin, use, wants_pin);
    return read_use_bus(*bus, use);
  }
  bool read_pin(const xml::Attribute& pin, Use& use, bool wants_pin) {
    if (!wants_pin) {
      at_value(diagnostics_, code::use_endpoint, pin,
               fmt::format("<use role=\"{}\"> takes a {}, not a pin", use.spec->role,
                           fmt::join(bus_kind_names(use.spec->buses), " or ")));
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
      reading_.report_unknown_bus(bus, reading_.segment_names(use.spec->buses));
      return false;
    }
    const Segment& segment = reading_.robot.segments[*use.segment];
    if (!reading_.kind_is_known(segment)) return false;
    if (contains(use.spec->buses, segment.bus_kind)) return segment.bus != kNoBus;
    at_value(
        diagnostics_, code::bus_kind, bus,
        fmt::format("<use role=\"{}\"> takes {}; bus '{}' is of type '{}'", use.spec->role,
                    fmt::join(bus_kind_names(use.spec->buses), " or "), bus.value, bus_kind_name(segment.bus_kind)));
    return false;
  }

  Reading& reading_;
  Diagnostics& diagnostics_;
  const xml::Node& tag_;
  Device& device_;
  std::string owner_ = fmt::format("device '{}'", device_.name.text);
};

}  // namespace

void read_uses(Reading& reading, const xml::Node& tag, Device& device) { UseReader(reading, tag, device).read(); }

}  // namespace finemote::gen
