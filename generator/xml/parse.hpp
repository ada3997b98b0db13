// Text to tree: a conforming XML parser (expat) with line and column on every element and attribute.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/xml/node.hpp"

namespace finemote::gen::xml {

/// Elements inside elements beyond this are refused, so that every reader of a tree may recurse over it.
inline constexpr std::size_t kMaxDepth = 512;

/// Why a text is no XML, in expat's words, which are also those of ROS xacro.
struct Malformed {
  Position at;               ///< column in bytes from 1, as everywhere
  std::string words;         ///< "mismatched tag"
  std::uint32_t line = 0;    ///< from 1
  std::uint32_t column = 0;  ///< in characters from 0, as expat and Python count
  Code code;
  Position open = {};  ///< the start tag that is still open, when an end tag is wrong or missing
  std::string open_name;
  bool open_has_children = false;
};

/// How to close the element that is still open: `close it with </device>`; an element that holds others cannot end in
/// `/>`.
std::string closing_hint(const Malformed& malformed);

/// Reads one document; the namespace prefixes have to be declared, the names stay as written.
std::variant<Document, Malformed> read_document(const SourceFile& file);

/// Parses one file. Reports FM1001 with expat's words and place, FM1003 when elements nest deeper than kMaxDepth;
/// then there is no document. Entities declared in the file are expanded by expat, within its amplification limit;
/// nothing external is read.
std::optional<Document> parse(const SourceFile& file, Diagnostics& diagnostics);

}  // namespace finemote::gen::xml
