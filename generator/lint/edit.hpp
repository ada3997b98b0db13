// Changes of a text that keep everything else of it: layout, comments, line ends.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/diagnostic/source.hpp"

namespace finemote::gen {

/// Bytes [begin, end) of a file become `text`.
struct Edit {
  const SourceFile* file = nullptr;
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string text;
};

/// Bytes of an element, from `<` to past its end tag; with the blanks before it on its line and the line break after it
/// where it stands on lines of its own.
struct ElementExtent {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Where the element whose tag begins at `at` stands. None when it came through a macro or an include, and when the
/// text at that place is no element.
std::optional<ElementExtent> find_element(const Position& at);

/// The extent with the comments that stand after it on its line, and on lines of their own directly above it: what is
/// said of the element.
ElementExtent with_comments(const SourceFile& file, ElementExtent extent);

/// The text of `file` after the edits; those of other files are passed over. Edits may not overlap; insertions at one
/// place keep their order.
std::string apply_edits(const SourceFile& file, std::vector<Edit> edits);

}  // namespace finemote::gen
