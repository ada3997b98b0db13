#include "generator/board_sources/port_objects.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <stdexcept>

#include "generator/bus/bus_type.hpp"

namespace finemote::gen {

PortClass port_class(const Port& port) { return bus_type(port.kinds.front()).port_class.value_or(PortClass::uart); }

std::vector<PortObject> port_objects(const Board& board) {
  std::vector<PortObject> objects;
  for (const Port& port : board.ports) objects.push_back({port.name, board.name, port_class(port), &port, {}});
  std::map<std::uint32_t, PinName> edges;  // by the number of their EXTI line
  std::set<std::string> converters;
  for (const NamedPin& pin : board.pins) {
    const PinName place = pin_name(pin.pin);
    if (pin.can("interrupt")) edges.emplace(place.number, place);
    if (!pin.converter.empty()) converters.insert(pin.converter);
  }
  for (const auto& [number, pin] : edges)
    objects.push_back({fmt::format("exti{}", number), board.name, PortClass::edge, nullptr, pin});
  for (const std::string& name : converters) objects.push_back({name, board.name, PortClass::adc, nullptr, {}});
  return objects;
}

const char* class_name(PortClass kind) {
  switch (kind) {
    case PortClass::uart:
      return "Uart";
    case PortClass::can:
      return "Can";
    case PortClass::i2c:
      return "I2c";
    case PortClass::spi:
      return "Spi";
    case PortClass::pwm:
      return "Pwm";
    case PortClass::edge:
      return "Edge";
    case PortClass::adc:
      return "Adc";
  }
  throw std::logic_error("no class of ports");
}

}  // namespace finemote::gen
