// What no JSON Schema can see in a board file: members that contradict each other.
#pragma once

#include "generator/descriptor/board.hpp"
#include "generator/descriptor/json_file.hpp"

namespace finemote::gen {

/// Reports FM3103, at the member of the texts that say the board: a port twice, a spare line that is taken, levels
/// or rates the wrong way round, a clock that the crystal does not make, ticks and pulse periods beyond the runtime's
/// limits, pins the package does not have.
void check_board(const Board& board, const Origin& origin, Diagnostics& diagnostics);

}  // namespace finemote::gen
