// A xacro file to the text that ROS xacro prints for it.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "generator/xacro/expand.hpp"

namespace finemote::gen::xacro {

/// `--package name=folder`
using PackageFolders = std::vector<std::pair<std::string, std::string>>;

/// Takes `name:=value` into `arguments` as ROS does: blanks around both are dropped, an empty value is ignored, and so
/// is a name like `_x`. Returns false when the word is none.
bool add_argument(std::string_view word, Arguments& arguments);

/// Where packages of an entry file are: the folders, the environment (which counts for nothing in a sandbox), and the
/// package the entry lies in.
PackagePath package_path(const std::string& entry, const PackageFolders& folders, const files::Access& access);

struct ExpandedFile {
  std::string document;
  std::vector<std::string> dependencies;  ///< all files read besides the input
};

/// Expands a file, or standard input for "-". None where an error was reported.
/// @param messages  as for expand()
std::optional<ExpandedFile> expand_file(const std::string& path, const Arguments& arguments,
                                        const PackageFolders& folders, Sources& sources, Diagnostics& diagnostics,
                                        std::ostream* messages = nullptr);

}  // namespace finemote::gen::xacro
