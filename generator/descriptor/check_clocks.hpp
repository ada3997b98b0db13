// The clocks of a board: those its chip can make, and that everything known of its times holds for.
#pragma once

#include "generator/descriptor/board.hpp"
#include "generator/descriptor/contradictions.hpp"

namespace finemote::gen {

/// FM3103 where the crystal and the PLL do not make the core's clock, where the chip cannot, where costs and bounds are
/// of other clocks, and where a port names another clock than that of the bus it hangs on.
void check_clocks(const Board& board, const Contradictions& found);

}  // namespace finemote::gen
