// The port objects of a board: what generated code can name below finemote::ports.
#pragma once

#include <string>
#include <vector>

#include "generator/bus/port_class.hpp"
#include "generator/descriptor/board.hpp"
#include "generator/descriptor/pin_name.hpp"

namespace finemote::gen {

struct PortObject {
  std::string name;   ///< `usart1`, `exti0`, `adc3`
  std::string board;  ///< whose port it is
  PortClass kind = PortClass::uart;
  const Port* port = nullptr;  ///< in the board file; null for edges and converters
  PinName edge;                ///< of an edge port: the pin, whose number is that of its EXTI line
};

/// Of the first kind of bus that the port serves; a serial port where that has none.
PortClass port_class(const Port& port);

/// Ports in the order of the board file, then edges by number, then converters by name. Every board has `gpio` beside.
std::vector<PortObject> port_objects(const Board& board);

/// `Uart`, before `Port` and `Hardware`.
const char* class_name(PortClass kind);

}  // namespace finemote::gen
