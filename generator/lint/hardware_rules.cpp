#include "generator/lint/hardware_rules.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace finemote::gen {
namespace {

bool contains(const std::vector<std::string>& pins, const std::string& pin) {
  return std::find(pins.begin(), pins.end(), pin) != pins.end();
}

/// The board file says where pins go, and this one goes nowhere: no name, no connector, no part.
bool leads_nowhere(const Board& board, const std::string& pin) {
  if (pin.empty() || board.connectors.empty() || board.named_pin(pin) != nullptr) return false;
  if (board.reserved_pin(pin) != nullptr) return false;
  return std::none_of(board.connectors.begin(), board.connectors.end(),
                      [&](const Connector& connector) { return contains(connector.pins, pin); });
}

void check_pin(const Board& board, const std::string& pin, Position at, std::size_t length, Findings& findings) {
  if (!leads_nowhere(board, pin)) return;
  findings.add(at, fmt::format("pin {} leads to no connector of board '{}'", pin, board.name))
      .underline(length)
      .note("without a wire soldered to the chip nothing is there")
      .hint("'finemote board show' lists the connectors and their pins");
}

bool provides(const DeviceType& type, const std::string& interface) {
  return std::any_of(type.provides.begin(), type.provides.end(),
                     [&](const Interface& provided) { return provided.name == interface; });
}

void check_output(const Robot& robot, const Device& device, Findings& findings) {
  if (!device.segment || !device.type->builtin || robot.segments[*device.segment].kind != Segment::Kind::bus) return;
  const Bus& bus = robot.buses[robot.segments[*device.segment].bus];
  const Port* port = robot.board->port(bus.port);
  if (port == nullptr || port->drives.empty() || provides(*device.type, port->drives)) return;
  findings
      .add(device, fmt::format("device '{}' of type '{}' drives port '{}', which has something else", device.name.text,
                               device.type->name, port->name))
      .note(fmt::format("port '{}': {}", port->name, port->connector))
      .note(fmt::format("bus '{}' is declared here", bus.name.text), bus.at);
}

}  // namespace

void find_odd_outputs(const Robot& robot, Findings& findings) {
  for (const Bus& bus : robot.buses)
    check_pin(*robot.board, bus.driver_pin, bus.driver_at, bus.driver_length, findings);
  for (const Device& device : robot.devices) {
    for (const Use& use : device.uses) check_pin(*robot.board, use.pin, use.at, 4, findings);
    check_output(robot, device, findings);
  }
}

}  // namespace finemote::gen
