// A board to what the emulated board is wired by: a part of its board file.
#pragma once

#include <nlohmann/json.hpp>

#include "generator/descriptor/board.hpp"

namespace finemote::gen {

/// As emulator/chip/wiring.hpp reads it. The board has clocks.
nlohmann::ordered_json board_wiring(const Board& board);

}  // namespace finemote::gen
