// Which further files a source reads, by what is written in it.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace finemote::gen {

/// The name of a file as a source has it.
struct FileName {
  std::string text;
  bool is_quoted = false;  ///< else it is in brackets, and is not looked for beside the file
  bool is_raw = false;     ///< an assembler reads it, byte by byte
  bool is_next = false;    ///< any of that name, and not only the first that is found
};

/// No `#if` is evaluated: what a compiler leaves out counts as well.
struct Directives {
  std::vector<FileName> names;        ///< that are included, asked for, or given to a macro
  std::vector<std::string> computed;  ///< a macro each, which makes a name; empty: what it takes to make it is not told
  /// That are defined, and the name of the file that each is; empty: it is none.
  std::map<std::string, std::set<std::string>> macros;
  bool asks_for_any = false;          ///< whether there is a file whose name a macro makes
  bool asks_macro = false;            ///< a condition has a macro with arguments
  bool has_pasted = false;            ///< a word is made of two: which one is not told
  bool is_read_by_assembler = false;  ///< what assembler code in it may read: names here, and any others
};

Directives directives_of(std::string_view source);

/// Whether logical lines make a word of two.
bool has_pasted_words(std::string_view lines);

}  // namespace finemote::gen
