#include "generator/lint/edit.hpp"

#include <algorithm>
#include <string_view>

#include "generator/xml/markup_tokens.hpp"

namespace finemote::gen {
namespace {

std::optional<std::size_t> offset_of(const Position& at) {
  if (at.file == nullptr || at.line == 0 || at.column == 0 || at.via != nullptr) return {};
  const std::string& text = at.file->text;
  std::size_t begin = 0;
  for (std::uint32_t line = 1; line < at.line; ++line) {
    begin = text.find('\n', begin);
    if (begin == std::string::npos) return {};
    ++begin;
  }
  const std::size_t offset = begin + at.column - 1;
  if (offset >= text.size() || text[offset] != '<') return {};
  return offset;
}

/// Past the end tag of the element at `from`. The text was parsed before, so tags match.
std::size_t end_of_element(std::string_view text, std::size_t from) {
  using Kind = MarkupToken::Kind;
  std::size_t depth = 0, at = from;
  while (at < text.size()) {
    const MarkupToken token = markup_token_at(text, at);
    at += token.bytes.size();
    if (token.kind == Kind::start) ++depth;
    if (token.kind == Kind::end) --depth;
    const bool is_tag = token.kind == Kind::start || token.kind == Kind::end || token.kind == Kind::empty;
    if (is_tag && depth == 0) break;
  }
  return at;
}

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// Takes in the rest of its lines when nothing else stands on them.
ElementExtent with_lines(std::string_view text, ElementExtent extent) {
  std::size_t begin = extent.begin;
  while (begin > 0 && is_blank(text[begin - 1])) --begin;
  std::size_t end = extent.end;
  while (end < text.size() && (is_blank(text[end]) || text[end] == '\r')) ++end;
  const bool is_alone = (begin == 0 || text[begin - 1] == '\n') && end < text.size() && text[end] == '\n';
  return is_alone ? ElementExtent{begin, end + 1} : extent;
}

/// Takes in comments after the element on its line, when nothing else stands on it.
ElementExtent with_comments_behind(std::string_view text, ElementExtent extent) {
  constexpr std::string_view kOpen = "<!--";
  std::size_t end = extent.end;
  while (end < text.size() && is_blank(text[end])) ++end;
  while (text.substr(end, kOpen.size()) == kOpen) {
    end += markup_token_at(text, end).bytes.size();
    while (end < text.size() && is_blank(text[end])) ++end;
  }
  const ElementExtent whole = with_lines(text, {extent.begin, end});
  return whole.end > end ? whole : extent;
}

}  // namespace

std::optional<ElementExtent> find_element(const Position& at) {
  const auto begin = offset_of(at);
  if (!begin) return {};
  return with_lines(at.file->text, {*begin, end_of_element(at.file->text, *begin)});
}

ElementExtent with_comments(const SourceFile& file, ElementExtent extent) {
  const std::string_view text = file.text;
  constexpr std::string_view kOpen = "<!--";
  constexpr std::string_view kClose = "-->";
  extent = with_comments_behind(text, extent);
  const auto is_line_begin = [&](std::size_t at) { return at == 0 || text[at - 1] == '\n'; };
  while (is_line_begin(extent.begin) && extent.begin > 0) {
    std::size_t end = extent.begin - 1;  // past the line above, without its line break
    while (end > 0 && (is_blank(text[end - 1]) || text[end - 1] == '\r')) --end;
    if (end < kClose.size() || text.substr(end - kClose.size(), kClose.size()) != kClose) break;
    std::size_t begin = text.rfind(kOpen, end - kClose.size());
    if (begin == std::string_view::npos) break;
    while (begin > 0 && is_blank(text[begin - 1])) --begin;
    if (!is_line_begin(begin)) break;  // something stands before it: the comment belongs to that
    extent.begin = begin;
  }
  return extent;
}

std::string apply_edits(const SourceFile& file, std::vector<Edit> edits) {
  std::stable_sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
  std::string result;
  std::size_t done = 0;
  for (const Edit& edit : edits) {
    if (edit.file != &file || edit.begin < done) continue;
    result.append(file.text, done, edit.begin - done);
    result += edit.text;
    done = edit.end;
  }
  result.append(file.text, done, std::string::npos);
  return result;
}

}  // namespace finemote::gen
