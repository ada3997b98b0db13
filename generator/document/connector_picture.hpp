// A connector to a picture of its contacts, as SVG.
#pragma once

#include <string>

#include "generator/descriptor/board.hpp"

namespace finemote::gen {

/// A box for every contact, lines of contacts below each other: number and name, then the pin of the chip and the ports
/// that use it. Boxes are as wide as the longest text. The colours follow the reader's light or dark setting and say
/// ground, supply, bus or none of these; nothing is said by colour alone.
std::string connector_picture(const Connector& connector, const Board& board);

}  // namespace finemote::gen
