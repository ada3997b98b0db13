// What a board connects to the pins of its chip, as its board file says.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace finemote::emulator {

struct PinPlace {
  char port = 'A';
  unsigned number = 0;
};

/// `PB12`
PinPlace pin_place(const std::string& name);

struct Wiring {
  struct I2cWires {
    std::string port;  ///< `i2c2`
    PinPlace scl, sda;
  };
  struct Select {
    std::string port;  ///< `spi1`; those of one port in the order of their channels
    PinPlace pin;
  };
  struct Pulse {
    std::string port;   ///< `pwm1`, `led_red`
    std::string timer;  ///< `tim1`
    unsigned channel = 0;
    PinPlace pin = {};
  };

  std::uint32_t crystal_hz = 12'000'000;
  std::vector<I2cWires> i2cs;
  std::vector<Select> selects;
  std::vector<Pulse> pulses;
};

/// Of a board file (finemote.board/1), or of as much of one: `clocks.crystal_hz`, `ports`.
/// @throws nlohmann::json::exception  the document has another shape
Wiring read_wiring(const nlohmann::ordered_json& board);

}  // namespace finemote::emulator
