#include "generator/diagnostic/place.hpp"

#include <fmt/format.h>

namespace finemote::gen {

std::string place_text(const Position& at) {
  if (at.file == nullptr) return "finemote";
  std::string text = at.file->name;
  if (at.line > 0) text += fmt::format(":{}", at.line);
  if (at.line > 0 && at.column > 0) text += fmt::format(":{}", at.column);
  return text;
}

Position outermost(Position at) {
  while (at.via != nullptr) at = at.via->at;
  return at;
}

}  // namespace finemote::gen
