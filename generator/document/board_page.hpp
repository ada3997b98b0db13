// A board to one reference page per peripheral, and their index.
#pragma once

#include <string>
#include <vector>

#include "generator/descriptor/board.hpp"

namespace finemote::gen {

/// A page of its own: `usart1`, `pins`, `README`, and the Markdown below its title.
struct BoardPage {
  std::string name;
  std::string title;
  std::string text;
};

/// The index first, then the ports in the order of the file, then the connectors and the single pins.
std::vector<BoardPage> board_pages(const Board& board);

}  // namespace finemote::gen
