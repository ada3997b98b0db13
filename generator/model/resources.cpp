// What ports and pins occupy on the chip: FM3015 (a port twice), FM3016 (two ports, or a pin, that need one thing) and
// FM3206 (a pin that the board needs itself). Whatever names a pin comes through this table.
#include <fmt/format.h>

#include <map>
#include <set>

#include "generator/bus/bus_type.hpp"
#include "generator/descriptor/pin_name.hpp"
#include "generator/diagnostic/code_hardware.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/bus_offers.hpp"
#include "generator/model/no_segment.hpp"
#include "generator/model/pins.hpp"
#include "generator/model/reading.hpp"

namespace finemote::gen {
namespace {

struct User {
  std::string what;  ///< `bus 'imu' (port 'usart1')`
  Position at;
};

/// A pin that somebody names, and where.
struct NamedUse {
  std::string pin;       ///< of the chip
  std::string function;  ///< input, output, interrupt or analog
  std::string who;       ///< `the direction of bus 'line'`
  Position user_at;      ///< what notes of other findings point at
  Position at;           ///< of the name
  std::size_t length;
  std::vector<std::string> ports;  ///< of the buses the user sits on
};

/// The port under a segment; empty: none, or an expander that sits on no bus.
std::string port_of(const Reading& reading, SegmentId segment) {
  const BusId bus = reading.robot.segments[segment].bus;
  return bus != kNoBus ? reading.robot.buses[bus].port : std::string();
}

std::vector<std::string> ports_of(const Reading& reading, const Device& device) {
  std::vector<std::string> ports;
  if (device.segment) ports.push_back(port_of(reading, *device.segment));
  for (const Use& use : device.uses) {
    if (use.segment) ports.push_back(port_of(reading, *use.segment));
  }
  return ports;
}

void add_uses(const Reading& reading, DeviceId index, std::vector<NamedUse>& pins) {
  const Device& device = reading.robot.devices[index];
  for (const Use& use : device.uses) {
    const xml::Attribute* name = use.pin.empty() ? nullptr : use_tag(reading, index, use).attribute("pin");
    if (name == nullptr) continue;
    pins.push_back({use.pin, use.spec->function,
                    fmt::format("device '{}' (use '{}')", device.name.text, use.spec->role), use.at, name->value_at,
                    name->value.size(), ports_of(reading, device)});
  }
}

/// A device on a gpio bus: its channel is a named pin of the board.
void add_channel(const Reading& reading, DeviceId index, std::vector<NamedUse>& pins) {
  const Device& device = reading.robot.devices[index];
  const xml::Attribute* channel = reading.device_tag(index).attribute("channel");
  if (!device.segment || !device.channel || channel == nullptr || reading.robot.board == nullptr) return;
  const auto& named = reading.robot.board->pins;
  const BusType& type = bus_type(reading.robot.segments[*device.segment].bus_kind);
  if (type.channels != BusType::Channels::pins || *device.channel >= named.size()) return;
  pins.push_back({named[*device.channel].pin,
                  named[*device.channel].functions.front(),
                  fmt::format("device '{}'", device.name.text),
                  device.at,
                  channel->value_at,
                  channel->value.size(),
                  {}});
}

/// Every pin that a tag of the robot names.
std::vector<NamedUse> named_uses(const Reading& reading) {
  std::vector<NamedUse> pins;
  for (const Bus& bus : reading.robot.buses) {
    if (bus.driver_pin.empty()) continue;
    pins.push_back({bus.driver_pin,
                    "output",
                    fmt::format("the direction of bus '{}'", bus.name.text),
                    bus.driver_at,
                    bus.driver_at,
                    bus.driver_length,
                    {}});
  }
  for (const DeviceId i : reading.robot.devices.ids()) {
    add_uses(reading, i, pins);
    add_channel(reading, i, pins);
  }
  return pins;
}

class ResourceTable {
 public:
  ResourceTable(Reading& reading, const std::vector<NamedUse>& pins) : reading_(reading) {
    for (const NamedUse& use : pins) named_.insert(use.pin);
  }

  void add_bus(BusId index) {
    const Port* port = reading_.buses[index].port;
    if (port == nullptr) return;
    const xml::Attribute& attribute = *reading_.tags.buses[index]->attribute("port");
    const Bus& bus = reading_.robot.buses[index];
    const auto [first, is_fresh] = ports_.emplace(port->name, index);
    if (!is_fresh) {
      Diagnostic& finding = at_value(reading_.diagnostics, code::port_twice, attribute,
                                     fmt::format("port '{}' is used twice", port->name));
      finding.note(fmt::format("bus '{}' uses it already", reading_.robot.buses[first->second].name.text),
                   reading_.robot.buses[first->second].at);
      std::string free;
      for (const std::string& name : suitable_ports(reading_, *reading_.tags.buses[index], bus.kind))
        free += (free.empty() ? "'" : ", '") + name + "'";
      if (!free.empty()) finding.hint(fmt::format("ports for {} that no bus names: {}", bus_kind_name(bus.kind), free));
      return;
    }
    const User self{fmt::format("bus '{}' (port '{}')", bus.name.text, port->name), bus.at};
    for (const Resource& resource : port->resources) take(resource, self, attribute.value_at, attribute.value.size());
  }
  void add_pin(const NamedUse& use) {
    const Board& board = *reading_.robot.board;
    if (!may_be_used(board, use.pin, use.function, use.ports)) return report_reserved(use);
    const User self{use.who, use.user_at};
    if (!take({"pin", use.pin}, self, use.at, use.length, &use)) return;
    if (use.function == "interrupt")
      take({"interrupt", fmt::format("EXTI{}", pin_name(use.pin).number)}, self, use.at, use.length);
  }

 private:
  void report_reserved(const NamedUse& use) {
    const ReservedPins& reserved = *reading_.robot.board->reserved_pin(use.pin);
    Diagnostic& finding =
        reading_.diagnostics
            .error(code::pin_reserved, use.at,
                   fmt::format("{} cannot use pin {}: the board needs it for {}", use.who, use.pin, reserved.purpose))
            .underline(use.length);
    if (!reserved.port.empty())
      finding.note(fmt::format("a device on a bus at port '{}' can use it as that part needs it", reserved.port));
    const std::string offer = free_pins(use);
    if (!offer.empty()) finding.hint(offer);
  }

  /// A pin of a connector that nothing of the robot uses, for an input or output; empty where there is none. No two
  /// findings offer the same.
  std::string free_pins(const NamedUse& use) {
    if (use.function != "input" && use.function != "output") return {};
    for (const Connector& connector : reading_.robot.board->connectors) {
      if (!connector.is_offered) continue;
      for (const std::string& pin : connector.pins) {
        if (!is_free(pin, use.function)) continue;
        offered_.insert(pin);
        return fmt::format("write '{}', which is on the {}", pin, connector.name);
      }
    }
    return {};
  }
  [[nodiscard]] bool is_free(const std::string& pin, const std::string& function) const {
    const Board& board = *reading_.robot.board;
    const NamedPin* named = board.named_pin(pin);
    if (board.reserved_pin(pin) != nullptr || (named != nullptr && !named->can(function))) return false;
    return !taken_.contains("pin" + pin) && !offered_.contains(pin) && !named_.contains(pin);
  }

  /// False: it is taken, which was reported. `pin`: for which another one is offered.
  bool take(const Resource& resource, const User& user, const Position& at, std::size_t length,
            const NamedUse* pin = nullptr) {
    const auto [first, is_fresh] = taken_.emplace(resource.kind + resource.name, user);
    if (is_fresh || first->second.what == user.what) return true;
    const std::string offer = pin != nullptr ? free_pins(*pin) : std::string();
    reading_.diagnostics
        .error(code::resource_conflict, at,
               fmt::format("{} and {} both need {} {}", user.what, first->second.what, resource.kind, resource.name))
        .underline(length)
        .note(fmt::format("{} is declared here", first->second.what), first->second.at)
        .hint(offer.empty() ? "'finemote board show' lists what each port needs" : offer);
    return false;
  }

  Reading& reading_;
  std::map<std::string, BusId> ports_;
  std::map<std::string, User> taken_;
  std::set<std::string> offered_, named_;
};

}  // namespace

void check_resources(Reading& reading) {
  if (reading.robot.board == nullptr) return;
  const std::vector<NamedUse> pins = named_uses(reading);
  ResourceTable table(reading, pins);
  for (const BusId i : reading.robot.buses.ids()) table.add_bus(i);
  for (const NamedUse& use : pins) table.add_pin(use);
}

}  // namespace finemote::gen
