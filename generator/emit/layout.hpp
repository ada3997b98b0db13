// Filled templates to lines: where a statement too wide for one line breaks, and in which column comments begin.
#pragma once

#include <string>
#include <string_view>

namespace finemote::gen {

/// A mark that templates name as if it were a value.
struct LayoutMark {
  const char* key;
  std::string_view text;  ///< what stands for it until laid_out(); no other text holds it
};

inline constexpr LayoutMark kLayoutMarks[] = {
    {"fit", "\x01"},      ///< begins what stays on one line where that fits
    {"break", "\x02"},    ///< a new line, where it does not
    {"end_fit", "\x03"},  ///< ends it
    {"column", "\x04"},   ///< blanks up to the column of comments after statements
    {"newline", "\n"},    ///< a new line in a partial that stands inside of a line
    {"brace", "{"},       ///< a brace of C++ before a tag
};

/// Stands in a line that is empty in the template, for mustache to keep it.
inline constexpr char kEmptyLine = 5;

/// Replaces the marks, leaves one of several blank lines in a row (a section that is left out leaves its own behind),
/// and ends comments that would take the next line into them.
std::string laid_out(const std::string& text);

}  // namespace finemote::gen
