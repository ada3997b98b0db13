// A board file to what the generator needs of it.
#pragma once

#include "generator/descriptor/board.hpp"
#include "generator/descriptor/json_file.hpp"

namespace finemote::gen {

/// Reads a board that its schema accepts. `source` is where contradictions (FM3103) are shown.
Board read_board(const Json& value, const SourceFile& source, Diagnostics& diagnostics);

}  // namespace finemote::gen
