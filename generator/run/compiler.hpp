// The compiler for the board.
#pragma once

#include <string>

namespace finemote::gen {

/// The first line of what it says of itself; empty: it is not there.
std::string compiler_for_board();

}  // namespace finemote::gen
