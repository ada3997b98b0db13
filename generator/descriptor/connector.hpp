// A place where wires leave the board, contact by contact.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace finemote::gen {

/// One contact of a connector.
struct Contact {
  std::string number;           ///< as the board's manual counts: `1`, `A1`
  std::string name;             ///< as it calls the contact: `GND`, `RXD`; that of the pin where it has none of its own
  std::string pin;              ///< of the chip, `PB7`; empty: none leads here
  std::string port;             ///< whose transceiver or inverter stands between; empty: none
  std::optional<double> volts;  ///< of a supply, 0 for ground
};

struct Connector {
  std::string name;                         ///< `8-pin user connector`
  std::string remark;                       ///< what a cable has to heed, in sentences; may be empty
  std::vector<std::vector<Contact>> lines;  ///< what lies side by side is a line; empty: only the pins are known
  std::vector<std::string> pins;            ///< of the chip, in the order of the contacts
  bool is_offered = true;                   ///< hints offer its pins
};

}  // namespace finemote::gen
