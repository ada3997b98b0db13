// A board file to one reference page per peripheral, and their index.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace finemote::gen {

/// A page of its own: `usart1`, `pins`, `README`, and the Markdown below its title.
struct BoardPage {
  std::string name;
  std::string title;
  std::string text;
};

/// `board` is the merged JSON document. The index first, then the ports in the order of the file, then the
/// single pins.
std::vector<BoardPage> board_pages(const nlohmann::ordered_json& board);

}  // namespace finemote::gen
