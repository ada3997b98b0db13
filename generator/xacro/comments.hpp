// Which comments belong to a xacro tag and vanish with it: those directly before it, at most one line break apart.
#pragma once

#include <cstdint>

#include "generator/xml/node.hpp"

namespace finemote::gen::xacro {

/// A tag also protects what its expansion put before it: a mark stands behind the tag that was expanded last, and a
/// search for comments stops there. There is one mark; setting it takes it away where it was.
class CommentMark {
 public:
  using Serial = std::uint32_t;

  /// Removes the comments at the end of `before`, the output so far of the tag's parent.
  /// @param has_next  something follows the tag in its source
  /// @return  what to give to set() once the tag's output is in place
  Serial remove_comments(xml::Node& before, bool has_next);

  /// Puts the mark at the end of `parent`, unless it has been set elsewhere since.
  void set(xml::Node& parent, Serial serial) const;

  /// Takes all marks but the valid one out of a finished tree; that one stays as two line breaks, as in ROS xacro.
  void clean(xml::Node& tree) const;

  /// True when the node is a mark that counts no more.
  [[nodiscard]] bool is_stale(const xml::Node& node) const;

 private:
  Serial current_ = 0;
};

}  // namespace finemote::gen::xacro
