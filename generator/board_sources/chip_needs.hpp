// What the drivers of the STM32F4 need to know of a port, and whether a board file says it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/descriptor/board.hpp"

namespace finemote::gen {

/// Null: the port has none.
const InterruptLine* interrupt_ending(const Port& port, std::string_view ending);
/// The interrupt called as the port itself: `USART1`; null where there is none.
const InterruptLine* own_interrupt(const Port& port);

/// `DMA2_Stream5`: the interrupt of a stream.
std::string interrupt_name(const DmaStream& stream);

/// What a board file on this chip lacks for its drivers, or contradicts; empty: nothing.
std::vector<std::string> mistakes_for_chip(const Board& board);

}  // namespace finemote::gen
