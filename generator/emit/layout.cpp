#include "generator/emit/layout.hpp"

#include <algorithm>

namespace finemote::gen {
namespace {

constexpr char kFit = 1, kBreak = 2, kEndFit = 3, kColumn = 4;
constexpr std::size_t kWidest = 118, kIndent = 4, kCommentColumn = 62;

std::size_t width_of_line(const std::string& text) { return text.size() - (text.rfind('\n') + 1); }

/// One piece between `fit` and `end_fit`, after what is written of its line already.
void add_fitted(std::string& written, const std::string& piece, std::size_t rest_of_line) {
  const auto breaks = static_cast<std::size_t>(std::count(piece.begin(), piece.end(), kBreak));
  const bool fits =
      piece.find('\n') == std::string::npos && width_of_line(written) + piece.size() - breaks + rest_of_line <= kWidest;
  for (const char c : piece) {
    if (c != kBreak) {
      written += c;
    } else if (!fits) {
      while (written.back() == ' ') written.pop_back();
      written += '\n' + std::string(kIndent, ' ');
    }
  }
}

std::string without_marks(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == kFit) {
      const std::size_t end = text.find(kEndFit, i);
      const std::size_t line_end = text.find('\n', end);
      add_fitted(result, text.substr(i + 1, end - i - 1), line_end - end - 1);
      i = end;
    } else if (text[i] == kColumn) {
      const std::size_t width = width_of_line(result);
      if (width < kCommentColumn) result.append(kCommentColumn - width, ' ');
    } else if (text[i] != kEmptyLine) {
      result += text[i];
    }
  }
  return result;
}

/// At most one blank line in a row: a section that is left out leaves its own blank lines behind.
std::string without_double_blanks(const std::string& text) {
  std::string result;
  result.reserve(text.size());
  std::size_t blanks = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    blanks = text[begin] == '\n' ? blanks + 1 : 0;
    if (blanks < 2) result.append(text, begin, end - begin);
    begin = end;
  }
  return result;
}

/// Compilers join such a line with the next one: it ends in a backslash, in the trigraph of one, or in either and
/// blanks.
bool joins_next(std::string_view line) {
  const std::size_t last = line.find_last_not_of(" \t");
  const std::string_view written = line.substr(0, last == std::string_view::npos ? 0 : last + 1);
  const auto ends_in = [&](std::string_view end) {
    return written.size() >= end.size() && written.substr(written.size() - end.size()) == end;
  };
  return ends_in("\\") || ends_in("?\?/");
}

/// A name at the end of a comment may end in a backslash, which would make the next line part of the comment.
std::string with_ended_lines(const std::string& text) {
  std::string result;
  result.reserve(text.size());
  std::size_t begin = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
    const std::string_view line = std::string_view(text).substr(begin, end - begin);
    result += line;
    result += joins_next(line) ? " //\n" : "\n";
    begin = end + 1;
  }
  return result.append(text, begin);
}

}  // namespace

std::string laid_out(const std::string& text) { return with_ended_lines(without_double_blanks(without_marks(text))); }

}  // namespace finemote::gen
