#include "generator/xacro/current_piece.hpp"

#include <string_view>

namespace finemote::gen::xacro {

Position place_inside(Position at, const std::string& text, std::size_t offset) {
  if (at.file == nullptr || at.line == 0 || at.column == 0) return at;
  std::string_view line = at.file->line(at.line);
  if (at.column > line.size() + 1) return at;
  line.remove_prefix(at.column - 1);
  Position moved = at;
  for (std::size_t i = 0; i < offset; ++i) {
    if (text[i] == '\n' && line.empty()) {
      line = at.file->line(++moved.line);
      moved.column = 1;
    } else if (!line.empty() && line[0] == text[i]) {
      line.remove_prefix(1);
      ++moved.column;
    } else {
      return at;
    }
  }
  return moved;
}

}  // namespace finemote::gen::xacro
