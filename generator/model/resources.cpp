// What ports and pins occupy on the chip: FM3015 (a port twice) and FM3016 (two ports, or a pin, that need one thing).
#include <fmt/format.h>

#include <map>

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
      at_value(reading_.diagnostics, code::port_twice, attribute, fmt::format("port '{}' is used twice", port->name))
          .note(fmt::format("bus '{}' uses it already", reading_.robot.buses[first->second].name.text),
                reading_.robot.buses[first->second].at);
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
  void take(const Resource& resource, const User& user, const Position& at, std::size_t length) {
    const auto [first, is_fresh] = taken_.emplace(resource.kind + resource.name, user);
    if (is_fresh || first->second.what == user.what) return;
    reading_.diagnostics
        .error(code::resource_conflict, at,
               fmt::format("{} and {} both need {} {}", user.what, first->second.what, resource.kind, resource.name))
        .underline(length)
        .note(fmt::format("{} stands here", first->second.what), first->second.at)
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
