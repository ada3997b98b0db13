#include "generator/xacro/text.hpp"

#include <algorithm>

namespace finemote::gen::xacro {
namespace {

/// What begins at the start of `rest`, and how long it is.
struct Match {
  Piece::Kind kind;
  std::size_t length;
};

/// `$$...{` or `$$...(`: length including the bracket, or 0.
std::size_t escape_length(std::string_view rest) {
  const auto end = rest.find_first_not_of('$');
  const bool has_bracket = end != std::string_view::npos && (rest[end] == '{' || rest[end] == '(');
  return end >= 2 && has_bracket ? end + 1 : 0;
}

Match match(std::string_view rest) {
  if (rest[0] != '$') return {Piece::Kind::plain, std::min(rest.find('$'), rest.size())};
  if (const std::size_t escaped = escape_length(rest); escaped > 0) return {Piece::Kind::plain, escaped};
  const char next = rest.size() > 1 ? rest[1] : '\0';
  if (next == '{' || next == '(') {
    const auto close = rest.find(next == '{' ? '}' : ')');
    if (close == std::string_view::npos) return {Piece::Kind::malformed, rest.size()};
    return {next == '{' ? Piece::Kind::expression : Piece::Kind::substitution, close + 1};
  }
  if (rest.size() == 1) return {Piece::Kind::plain, 1};
  const auto end = std::min(rest.find_first_of("{($", 1), rest.size());
  return end > 1 ? Match{Piece::Kind::plain, end} : Match{Piece::Kind::malformed, rest.size()};
}

std::unique_ptr<const Text> inner_text(std::string_view inside) {
  if (inside.find('$') == std::string_view::npos) return nullptr;
  return std::make_unique<const Text>(cut_text(inside));
}

Piece make_piece(const Match& match, std::string_view spelling, std::size_t offset) {
  Piece piece;
  piece.kind = match.kind;
  piece.offset = offset;
  const bool is_bracketed = match.kind == Piece::Kind::expression || match.kind == Piece::Kind::substitution;
  if (is_bracketed) {
    const std::string_view inside = spelling.substr(2, spelling.size() - 3);
    piece.text = inside;
    piece.inner = inner_text(inside);
  } else {
    const bool is_escape = match.kind == Piece::Kind::plain && escape_length(spelling) > 0;
    piece.text = spelling.substr(is_escape ? 1 : 0);
  }
  return piece;
}

}  // namespace

Text cut_text(std::string_view text) {
  Text cut;
  for (std::size_t at = 0; at < text.size();) {
    const Match found = match(text.substr(at));
    cut.pieces.push_back(make_piece(found, text.substr(at, found.length), at));
    at += found.length;
  }
  return cut;
}

}  // namespace finemote::gen::xacro
