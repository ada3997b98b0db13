// Which files the sources of a robot's own device types include.
#pragma once

#include <string>
#include <vector>

#include "generator/file/access.hpp"

namespace finemote::gen {

struct SourceText {
  std::string name;  ///< as the including line writes it
  std::string path;  ///< empty: of a generated file, beside which nothing is looked for
  std::string text;
  bool is_raw = false;   ///< an assembler reads it, byte by byte
  bool is_whole = true;  ///< false: it is larger than any source, and was not read
};

/// Whether a file is called as those that a compiler reads usually are.
bool has_source_name(const std::string& name);

/// What `sources` include, what that includes, and so on, each file once; `sources` themselves are not in it. A line
/// that a compiler leaves out counts as well, for no `#if` is evaluated. What is found neither beside the file that
/// includes it nor in `folders` belongs to the runtime or to the compiler. A macro that stands for a name counts as
/// included. Where another macro makes the name, or an assembler includes, every file beside it, in `folders` and below
/// them counts that neither FineMote nor a build has made.
/// @param shipped  sources whose includes `folders` may have files for as well
/// @param folders  what the compiler looks through, in this order
std::vector<SourceText> included_files(const std::vector<SourceText>& sources, const std::vector<SourceText>& shipped,
                                       const std::vector<std::string>& folders, const files::Access& access);

}  // namespace finemote::gen
