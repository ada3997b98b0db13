// The jumpers of the bench kit: wires from an output of a bus to its own input, as a drawing and for the emulated
// board.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "generator/descriptor/board.hpp"

namespace finemote::gen {

struct Jumper {
  std::string name;                        ///< `J1`
  std::string port, connector;             ///< `usart1`, and where it leaves the board
  std::string from, from_pin, to, to_pin;  ///< `tx`, `PA9`, `rx`, `PB7`
};

/// J1 at a serial port, J2 at an SPI port.
std::vector<Jumper> bench_jumpers(const Board& board);

/// An SVG with a wire for each.
std::string jumper_drawing(const std::vector<Jumper>& jumpers);

/// The same as parts of a scenario (finemote.scenario/1).
nlohmann::ordered_json jumper_scenario(const std::vector<Jumper>& jumpers);

}  // namespace finemote::gen
