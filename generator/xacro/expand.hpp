// A xacro file to plain XML, in which every element and attribute knows where it was written and how it got there.
#pragma once

#include <iosfwd>
#include <optional>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/xacro/arguments.hpp"
#include "generator/xacro/input_files.hpp"
#include "generator/xacro/packages.hpp"
#include "generator/xml/node.hpp"

namespace finemote::gen::xacro {

/// Expands a file as ROS xacro does (noetic and ROS 2 up to 2.0; docs/reference/xacro.md names the differences).
///
/// Reports the first error (FM1001 to FM1049), at the text to blame, with the chain of macro calls and includes in the
/// position, and all warnings (FM1050 to FM1099); after an error there is no document. The message is the one of ROS
/// xacro where that has one.
///
/// @param messages  where xacro.message() and xacro.print_location() write; they are dropped when it is null
std::optional<xml::Document> expand(const SourceFile& entry, const Arguments& arguments, const PackagePath& packages,
                                    Sources& sources, Diagnostics& diagnostics, Dependencies& dependencies,
                                    std::ostream* messages = nullptr);

}  // namespace finemote::gen::xacro
