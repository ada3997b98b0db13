// What two XML documents have in common for a robot: names, attributes and texts; not order of attributes or layout.
#pragma once

#include <string>

#include "generator/xml/node.hpp"

namespace finemote::gen::conformance {

/// The first difference between two trees, or an empty text. Runs of white space count as one blank, and text of white
/// space alone does not count. Comments count only if asked for.
std::string difference(const xml::Node& expected, const xml::Node& given, bool with_comments);

/// Runs of blanks, tabs and line breaks as one blank, none at the ends.
std::string squeezed(const std::string& text);

}  // namespace finemote::gen::conformance
