// Which further files a source reads, by what is written in it.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace finemote::gen {

/// The name of a file as a source has it.
struct FileName {
  std::string text;
  bool is_quoted = false;  ///< else it is in brackets, and is not looked for beside the file
};

/// No `#if` is evaluated: what a compiler leaves out counts as well.
struct Directives {
  std::vector<FileName> names;        ///< that are included, asked for, or given to a macro
  std::vector<std::string> computed;  ///< a macro each, which makes a name; empty: what it takes to make it is not told
  std::map<std::string, bool> macros;  ///< that are defined, and whether each is the name of one file
  bool is_read_by_assembler = false;   ///< what assembler code in it may read: names here, and any others
};

Directives directives_of(std::string_view source);

}  // namespace finemote::gen
