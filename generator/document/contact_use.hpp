// A contact of a connector to what a robot can do with it.
#pragma once

#include <string>
#include <vector>

#include "generator/descriptor/board.hpp"

namespace finemote::gen {

/// How a port uses a contact.
struct PortUse {
  const Port* port = nullptr;
  std::string signal;  ///< `rx`, `select`, `tim1_ch1`; empty: something stands between pin and contact
};

/// Points into the board.
struct ContactUse {
  std::vector<PortUse> ports;              ///< in the order of the board's file
  const NamedPin* named = nullptr;         ///< null: the pin has no name of its own
  const ReservedPins* reserved = nullptr;  ///< null: the pin is free where no bus uses a port of it
};

ContactUse use_of(const Contact& contact, const Board& board);

}  // namespace finemote::gen
