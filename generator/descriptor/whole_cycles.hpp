// Ticks that a board's core counts without remainder: releases would drift otherwise.
#pragma once

#include "generator/descriptor/board.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen {

bool is_whole_cycles(const Board& board, Duration tick);

/// The nearest tick from `tick` on that is whole.
Duration whole_tick_above(const Board& board, Duration tick);

}  // namespace finemote::gen
