#include "generator/diagnostic/place.hpp"

#include <fmt/format.h>

namespace finemote::gen {

namespace {

std::string place_text(const Position& at, std::string text) {
  if (at.line > 0) text += fmt::format(":{}", at.line);
  if (at.line > 0 && at.column > 0) text += fmt::format(":{}", at.column);
  return text;
}

}  // namespace

std::string place_text(const Position& at) { return at.file == nullptr ? "finemote" : place_text(at, at.file->name); }

std::string place_for_programs(const Position& at) {
  return at.file == nullptr ? "finemote" : place_text(at, at.file->place());
}

Position outermost(Position at) {
  while (at.via != nullptr) at = at.via->at;
  return at;
}

}  // namespace finemote::gen
