#include "generator/timing_file/logical_lines.hpp"

#include <algorithm>
#include <cctype>

namespace finemote::gen {

bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

namespace {

std::string spliced(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view rest = text.substr(i);
    const std::size_t end = text[i] == '\\' ? rest.find_first_not_of(" \t\f\v\r", 1) : std::string_view::npos;
    const std::size_t skipped = end != std::string_view::npos && rest[end] == '\n' ? end + 1 : 0;
    if (skipped == 0)
      out += text[i];
    else
      i += skipped - 1;
  }
  return out;
}

/// Where the literal that begins at `begin` ends: after its quote, or at the end of its line.
std::size_t end_of_literal(std::string_view text, std::size_t begin) {
  for (std::size_t i = begin + 1; i < text.size(); ++i) {
    if (text[i] == '\n') return i;
    if (text[i] == text[begin]) return i + 1;
    if (text[i] == '\\') ++i;
  }
  return text.size();
}

bool begins_number(std::string_view text, std::size_t at) {
  return std::isdigit(static_cast<unsigned char>(text[at])) != 0 && (at == 0 || !is_of_word(text[at - 1]));
}

/// After a number, whose digits a quote may separate.
std::size_t end_of_number(std::string_view text, std::size_t begin) {
  std::size_t end = begin;
  while (end < text.size() && (is_of_word(text[end]) || text[end] == '.' ||
                               (text[end] == '\'' && end + 1 < text.size() && is_of_word(text[end + 1]))))
    ++end;
  return end;
}

/// Whether the quote at `at` begins a raw string: `R"`, `u8R"` and the like.
bool is_raw(std::string_view text, std::size_t at) {
  std::size_t begin = at;
  while (begin > 0 && is_of_word(text[begin - 1])) --begin;
  const std::string_view prefix = text.substr(begin, at - begin);
  return prefix == "R" || prefix == "u8R" || prefix == "uR" || prefix == "UR" || prefix == "LR";
}

/// Where the raw string whose quote is at `at` ends: after the same word as it began with.
std::size_t end_of_raw(std::string_view text, std::size_t at) {
  const std::size_t open = text.find('(', at);
  if (open == std::string_view::npos) return text.size();
  const std::string closing = ")" + std::string(text.substr(at + 1, open - at - 1)) + '"';
  const std::size_t end = text.find(closing, open);
  return end == std::string_view::npos ? text.size() : end + closing.size();
}

std::size_t end_of_quoted(std::string_view text, std::size_t at) {
  return text[at] == '"' && is_raw(text, at) ? end_of_raw(text, at) : end_of_literal(text, at);
}

bool begins_comment(std::string_view text, std::size_t at) {
  return text[at] == '/' && at + 1 < text.size() && (text[at + 1] == '/' || text[at + 1] == '*');
}

std::size_t end_of_comment(std::string_view text, std::size_t begin) {
  const bool is_line = text[begin + 1] == '/';
  const std::size_t end = text.find(is_line ? "\n" : "*/", begin + 2);
  if (end == std::string_view::npos) return text.size();
  return is_line ? end : end + 2;
}

std::size_t end_of_token(std::string_view text, std::size_t begin) {
  if (text[begin] == '"' || text[begin] == '\'') return end_of_quoted(text, begin);
  return begins_number(text, begin) ? end_of_number(text, begin) : begin + 1;
}

}  // namespace

std::string without_returns(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.substr(i, 2) != "\r\n") out += text[i];
  }
  return out;
}

std::string logical_lines(std::string_view text) {
  std::string lines = without_returns(text);
  std::replace(lines.begin(), lines.end(), '\r', '\n');  // alone it ends a line, too
  const std::string whole = spliced(lines);
  std::string out;
  for (std::size_t i = 0; i < whole.size();) {
    const bool is_comment = begins_comment(whole, i);
    const std::size_t end = is_comment ? end_of_comment(whole, i) : end_of_token(whole, i);
    out += is_comment ? " " : whole.substr(i, end - i);
    i = end;
  }
  return out;
}

}  // namespace finemote::gen
