// The name of a pin, the board's or the chip's, to the pin of the chip.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/model/robot.hpp"

namespace finemote::gen {

/// A pin that a robot uses.
struct PlacedPin {
  std::string pin;                  ///< of the chip: `PA0`; empty: none
  const NamedPin* named = nullptr;  ///< what the board file says of it; null: nothing
};

/// What somebody needs a pin for.
struct PinNeed {
  std::string function;             ///< input, output, interrupt or analog
  const NamedPin* wired = nullptr;  ///< the only pin that the board wires to it; null: any that can do it
};

/// Finds the pin `name` (at `at`), which `user` needs.
/// Reports FM3073 (no such pin) and FM3076 (it cannot be that on this board); the result is then empty.
PlacedPin find_pin(const Board* board, const std::string& name, const Position& at, const std::string& user,
                   const PinNeed& need, Diagnostics& diagnostics);

/// The data-ready line of the part that the board carries at a port, with this chip select; null: it carries none.
const NamedPin* data_ready_line(const Board& board, const std::string& port, std::optional<std::uint32_t> channel);

/// Whether a device on buses at `ports` may use the pin as `function`, as far as the board needs it itself. Whoever
/// wants to may listen to the interrupt line of an on-board part; anything else is for devices on that part's bus.
bool may_be_used(const Board& board, const std::string& pin, const std::string& function,
                 const std::vector<std::string>& ports);

}  // namespace finemote::gen
