// `finemote xacro`: the drop-in for ROS xacro's command.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "generator/xacro/expand.hpp"

namespace finemote::gen::xacro {

struct XacroOptions {
  std::string input;  ///< a path, or "-" for standard input
  Arguments arguments;
  std::string output;              ///< `-o`: the file to write, with its folders; standard output when empty
  bool only_dependencies = false;  ///< `--deps`: names of all files read besides the input, with blanks between them
  bool in_order = false;           ///< `-i`, `--inorder`: accepted, a remark only
  int verbosity = 1;               ///< `-q` is 0: no warnings
  std::vector<std::pair<std::string, std::string>> packages;  ///< `--package name=folder`
  files::Access access = {};  ///< which files may be read; in a sandbox the environment names no packages
  bool color = false;
};

/// Takes `name:=value` into `arguments` as ROS does: blanks around both are dropped, an empty value is ignored, and so
/// is a name like `_x`. Returns false when the word is none.
bool add_argument(std::string_view word, Arguments& arguments);

struct Expanded {
  std::string document;
  std::vector<std::string> dependencies;  ///< all files read besides the input
};

/// Expands the input; writes nothing but xacro's own messages, to `err`. None where an error was reported.
std::optional<Expanded> expand_input(const XacroOptions& options, Sources& sources, Diagnostics& diagnostics,
                                     std::ostream& err);

/// What goes to standard output or the output file: the document, or with `--deps` the names of the files.
std::string result_text(const Expanded& expansion, const XacroOptions& options);

/// Writes the output file, with its folders, as ROS xacro does; a failure (FM1029, or FM5013 for a file
/// that was read) leaves the old file.
void write_output_file(const std::string& path, const std::string& text, Diagnostics& diagnostics, Sources& sources);

/// The findings that the verbosity lets through.
Diagnostics heard(const Diagnostics& all, const XacroOptions& options);

/// Expands and writes. Returns 0, or 2 after an error; then nothing is written to `out` or the output file.
int run_xacro(const XacroOptions& options, std::ostream& out, std::ostream& err);

}  // namespace finemote::gen::xacro
