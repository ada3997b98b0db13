// The connectors of a board to a page of the reference, and their pictures.
#pragma once

#include <string>
#include <vector>

#include "generator/descriptor/board.hpp"

namespace finemote::gen {

/// A file beside the page.
struct Picture {
  std::string name;  ///< `8_pin_user_connector.svg`
  std::string svg;
};

/// Those whose contacts the board's file describes, in its order.
std::vector<Picture> connector_pictures(const Board& board);

/// A section for each connector: remark, picture, and what a robot can do with each contact. Markdown.
std::string connector_page(const Board& board);

}  // namespace finemote::gen
