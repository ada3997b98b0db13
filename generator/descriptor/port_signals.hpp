// The pin and the DMA stream of a signal of a port.
#pragma once

#include <string_view>

#include "generator/descriptor/board.hpp"

namespace finemote::gen {

/// @param signal  as the board file names it: `tx`, `sck`
/// @return null: the port has none
const PortPin* signal_pin(const Port& port, std::string_view signal);
const DmaStream* dma_for(const Port& port, std::string_view signal);

}  // namespace finemote::gen
