// The port objects of a board on an STM32F4, one file each.
#pragma once

#include <vector>

#include "generator/board_sources/port_objects.hpp"
#include "generator/emit/render.hpp"

namespace finemote::gen {

/// `ports/usart1.cpp` and its kin. Edges that share an interrupt line share a file. The board has no
/// mistakes_for_chip().
std::vector<OutputFile> chip_ports(const Board& board, Templates& templates);

}  // namespace finemote::gen
