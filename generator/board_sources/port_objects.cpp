#include "generator/board_sources/port_objects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace finemote::gen {
namespace {

PortClass class_of(const Port& port) {
  switch (port.kinds.front()) {
    case BusKind::can:
      return PortClass::can;
    case BusKind::i2c:
      return PortClass::i2c;
    case BusKind::spi:
      return PortClass::spi;
    case BusKind::pwm:
      return PortClass::pwm;
    default:
      return PortClass::uart;
  }
}

}  // namespace

std::vector<PortObject> port_objects(const Board& board) {
  std::vector<PortObject> objects;
  for (const Port& port : board.ports) objects.push_back({port.name, board.name, class_of(port), &port, {}});
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
