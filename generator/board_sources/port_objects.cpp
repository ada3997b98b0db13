#include "generator/board_sources/port_objects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "generator/bus/bus_type.hpp"

namespace finemote::gen {

PortClass port_class(const Port& port) { return bus_type(port.kinds.front()).port_class.value_or(PortClass::uart); }

std::vector<PortObject> port_objects(const Board& board) {
  std::vector<PortObject> objects;
  for (const Port& port : board.ports) objects.push_back({port.name, board.name, port_class(port), &port, {}});
  std::map<std::uint32_t, char> edges;
  std::set<std::string> converters;
  for (const NamedPin& pin : board.pins) {
    if (pin.can("interrupt")) edges.emplace(std::stoul(pin.pin.substr(2)), pin.pin.at(1));
    if (!pin.converter.empty()) converters.insert(pin.converter);
  }
  for (const auto& [number, port] : edges)
    objects.push_back({fmt::format("exti{}", number), board.name, PortClass::edge, nullptr, {port, number}});
  for (const std::string& name : converters) objects.push_back({name, board.name, PortClass::adc, nullptr, {}});
  return objects;
}

const char* class_name(PortClass kind) {
  constexpr const char* kNames[] = {"Uart", "Can", "I2c", "Spi", "Pwm", "Edge", "Adc"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::uint32_t interrupt_of(const EdgeSource& edge) {
  return edge.number < 5 ? 6 + edge.number : edge.number < 10 ? 23 : 40;
}

}  // namespace finemote::gen
