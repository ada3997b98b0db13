// What ports and pins occupy on the chip: FM3015 (a port twice) and FM3016 (two ports, or a pin, that need one thing).
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "generator/descriptor/bus_kind.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/reading.hpp"

namespace finemote::gen {
namespace {

struct User {
  std::string what;  ///< `bus 'imu' (port 'usart1')`
  Position at;
};

class ResourceTable {
 public:
  explicit ResourceTable(Reading& reading) : reading_(reading) {}

  void add_bus(std::size_t index) {
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
      const std::string free = free_ports(bus.kind);
      if (!free.empty()) finding.hint(fmt::format("ports for {} that no bus names: {}", bus_kind_name(bus.kind), free));
      return;
    }
    const User self{fmt::format("bus '{}' (port '{}')", bus.name.text, port->name), bus.at};
    for (const Resource& resource : port->resources) take(resource, self, attribute.value_at, attribute.value.size());
    if (bus.driver_pin.empty()) return;
    take({"pin", bus.driver_pin}, {fmt::format("the direction of bus '{}'", bus.name.text), bus.driver_at},
         bus.driver_at, bus.driver_pin.size());
  }
  void add_pin(const Use& use, const Device& device, const xml::Attribute& attribute) {
    take({"pin", use.pin}, {fmt::format("device '{}' (use '{}')", device.name.text, use.spec->role), use.at},
         attribute.value_at, attribute.value.size());
  }

 private:
  /// Ports of the board that serve the kind and that no <bus> names.
  std::string free_ports(BusKind kind) const {
    std::string list;
    for (const Port& port : reading_.robot.board->ports) {
      const bool serves = std::find(port.kinds.begin(), port.kinds.end(), kind) != port.kinds.end();
      const bool is_named = std::any_of(reading_.tags.buses.begin(), reading_.tags.buses.end(),
                                        [&](const xml::Node* tag) { return value_of(*tag, "port") == port.name; });
      if (serves && !is_named) list += (list.empty() ? "'" : ", '") + port.name + "'";
    }
    return list;
  }

  void take(const Resource& resource, const User& user, const Position& at, std::size_t length) {
    const auto [first, is_fresh] = taken_.emplace(resource.kind + resource.name, user);
    if (is_fresh || first->second.what == user.what) return;
    reading_.diagnostics
        .error(code::resource_conflict, at,
               fmt::format("{} and {} both need {} {}", user.what, first->second.what, resource.kind, resource.name))
        .underline(length)
        .note(fmt::format("{} is declared here", first->second.what), first->second.at)
        .hint("'finemote board show' lists what each port needs");
  }

  Reading& reading_;
  std::map<std::string, std::size_t> ports_;
  std::map<std::string, User> taken_;
};

}  // namespace

void check_resources(Reading& reading) {
  ResourceTable table(reading);
  for (std::size_t i = 0; i < reading.robot.buses.size(); ++i) table.add_bus(i);
  for (std::size_t i = 0; i < reading.robot.devices.size(); ++i) {
    const Device& device = reading.robot.devices[i];
    for (const Use& use : device.uses) {
      if (use.pin.empty()) continue;
      for (const xml::Node& child : reading.device_tag(i).children) {
        if (child.is_element("use") && value_of(child, "role") == use.spec->role && child.attribute("pin") != nullptr)
          table.add_pin(use, device, *child.attribute("pin"));
      }
    }
  }
}

}  // namespace finemote::gen
