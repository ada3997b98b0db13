#include "generator/xacro/comments.hpp"

#include <algorithm>

#include "generator/xml/write.hpp"

namespace finemote::gen::xacro {
namespace {

/// A mark is a text node with a name, which no text of a file has; its line is the serial number.
constexpr const char* kMark = "mark";

bool is_mark(const xml::Node& node) { return node.kind == xml::Node::Kind::text && !node.name.empty(); }

/// White space that does not separate a comment from the tag after it.
bool is_thin_gap(const xml::Node& node) {
  return node.kind == xml::Node::Kind::text && !node.text.empty() && xml::is_blank_text(node.text) &&
         std::count(node.text.begin(), node.text.end(), '\n') <= 1;
}

}  // namespace

bool CommentMark::is_stale(const xml::Node& node) const { return is_mark(node) && node.at.line != current_; }

CommentMark::Serial CommentMark::remove_comments(xml::Node& before, bool has_next) {
  auto& nodes = before.children;
  std::size_t at = nodes.size();  // the nodes before `at` are still to be looked at
  const auto skip_stale = [&] {
    while (at > 0 && is_stale(nodes[at - 1])) --at;
  };
  for (skip_stale(); at > 0; skip_stale()) {
    if (is_thin_gap(nodes[at - 1])) --at, skip_stale();
    const bool is_comment = at > 0 && nodes[at - 1].kind == xml::Node::Kind::comment;
    if (!is_comment) return has_next ? ++current_ : 0;
    nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(at - 1));
    --at;
  }
  return 0;
}

void CommentMark::set(xml::Node& parent, Serial serial) const {
  if (serial == 0 || serial != current_) return;
  xml::Node mark;
  mark.kind = xml::Node::Kind::text;
  mark.name = kMark;
  mark.text = "\n\n";
  mark.at.line = serial;
  parent.children.push_back(std::move(mark));
}

void CommentMark::clean(xml::Node& tree) const {
  auto& nodes = tree.children;
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(), [&](const xml::Node& n) { return is_stale(n); }), nodes.end());
  for (xml::Node& node : nodes) {
    if (is_mark(node)) node.name.clear(), node.at = {};
    clean(node);
  }
}

}  // namespace finemote::gen::xacro
