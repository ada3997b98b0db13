// Text to tree: a conforming XML parser (expat) with line and column on every element and attribute.
#pragma once

#include <optional>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/xml/node.hpp"

namespace finemote::gen::xml {

/// Parses one file. Reports FM1001 with expat's words and place; then there is no document.
/// Entities declared in the file are expanded by expat, within its amplification limit; nothing external is read.
/// Nesting deeper than 512 elements is an error.
std::optional<Document> parse(const SourceFile& file, Diagnostics& diagnostics);

}  // namespace finemote::gen::xml
