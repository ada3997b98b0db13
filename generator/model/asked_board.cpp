#include "generator/model/asked_board.hpp"

namespace finemote::gen {
namespace {

/// The first, which is the one that counts; null: there is none.
const xml::Node* find_board_tag(const xml::Node& robot) {
  for (const xml::Node& block : robot.children) {
    if (!block.is_element("finemote")) continue;
    for (const xml::Node& child : block.children) {
      if (child.is_element("board")) return &child;
    }
  }
  return nullptr;
}

}  // namespace

std::string asked_board(const xml::Document& document, const std::string& board) {
  const xml::Node* tag = find_board_tag(document.root);
  const xml::Attribute* own = tag != nullptr ? tag->attribute("name") : nullptr;
  return own != nullptr && own->value == board ? std::string() : board;
}

}  // namespace finemote::gen
