// Which comments belong to a xacro tag and vanish with it: those directly before it, at most one line break apart.
#pragma once

#include <cstdint>

#include "generator/xml/node.hpp"

namespace finemote::gen::xacro {

/// An element that is being built, and from where on its children are what a tag sees before it: the content of a
/// condition or macro is built in place, yet is a world of its own until it is complete.
struct Sink {
  xml::Node& element;
  std::uint64_t id;       ///< of the element, unique in an expansion
  std::size_t floor = 0;  ///< children before it are out of sight

  [[nodiscard]] std::size_t end() const { return element.children.size(); }
};

/// A tag also protects what its expansion put before it: a mark stands after the tag that was expanded last, and a
/// search for comments stops there. There is one mark; setting it takes it away where it was.
class CommentMark {
 public:
  using Serial = std::uint64_t;

  /// Removes the comments before the child at `end` of the element.
  /// @param has_next  something follows the tag in its source
  /// @return  what to give to set() once the tag's output is in place
  Serial remove_comments(Sink& before, std::size_t end, bool has_next);
  Serial remove_comments(Sink& before, bool has_next) { return remove_comments(before, before.end(), has_next); }

  /// Puts the mark after the last child, unless it has been set elsewhere since.
  void set(const Sink& sink, Serial serial);

 private:
  Serial current_ = 0;
  std::uint64_t element_ = 0;  // where the mark is; 0 for nowhere
  std::size_t place_ = 0;      // it stands before the child with this index
};

}  // namespace finemote::gen::xacro
