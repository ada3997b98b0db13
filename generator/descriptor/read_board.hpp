// A board file to what the generator needs of it.
#pragma once

#include "generator/descriptor/board.hpp"
#include "generator/descriptor/json_file.hpp"

namespace finemote::gen {

/// Reads a board that its schema accepts. `origin` is where contradictions (FM3103) are shown.
Board read_board(const Json& value, const Origin& origin, Diagnostics& diagnostics);

}  // namespace finemote::gen
