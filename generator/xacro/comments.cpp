#include "generator/xacro/comments.hpp"

#include <algorithm>

#include "generator/xml/write.hpp"

namespace finemote::gen::xacro {
namespace {

/// White space that does not separate a comment from the tag after it.
bool is_thin_gap(const xml::Node& node) {
  return node.kind == xml::Node::Kind::text && !node.text.empty() && xml::is_blank_text(node.text) &&
         std::count(node.text.begin(), node.text.end(), '\n') <= 1;
}

}  // namespace

CommentMark::Serial CommentMark::remove_comments(Sink& before, std::size_t end, bool has_next) {
  auto& nodes = before.element.children;
  std::size_t at = end;  // the nodes before `at` are still to be looked at
  const auto is_mark = [&] { return element_ == before.id && place_ == at; };
  while (at > before.floor || is_mark()) {
    if (!is_mark() && is_thin_gap(nodes[at - 1])) --at;
    const bool is_comment = !is_mark() && at > before.floor && nodes[at - 1].kind == xml::Node::Kind::comment;
    if (!is_comment) {
      if (!has_next) return 0;
      element_ = 0;  // the mark is on its way to its new place
      return ++current_;
    }
    nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(at - 1));
    if (element_ == before.id && place_ >= at) --place_;
    --at;
  }
  return 0;
}

void CommentMark::set(const Sink& sink, Serial serial) {
  if (serial == 0 || serial != current_) return;
  element_ = sink.id;
  place_ = sink.end();
}

}  // namespace finemote::gen::xacro
