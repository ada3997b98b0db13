// What a scenario can make happen at the ports and pins of the board, whatever hangs there.
#pragma once

#include "emulator/board.hpp"
#include "emulator/outfit/entry.hpp"

namespace finemote::emulator {

/// Makes the event's `do` happen at its `port`. @throws std::invalid_argument: it cannot
void happen_to_port(Board& board, const Json& event);

/// Drives the event's `pin`, or leaves it alone. @throws std::invalid_argument: it cannot
void happen_to_pin(Board& board, const Json& event);

}  // namespace finemote::emulator
