#include "generator/expression/token_cursor.hpp"

#include <algorithm>

namespace finemote::gen::expression {
namespace {

constexpr std::size_t kMaxChain = 2'000;  // a chain is a tree as deep as it is long

bool begins_operand(const Token& t) {
  if (t.kind == Token::Kind::name) return !is_keyword(t.spelling) || t.spelling == "True" || t.spelling == "False";
  return t.kind == Token::Kind::number || t.kind == Token::Kind::text;
}

bool ends_operand(const Token& t) {
  return begins_operand(t) || t.spelling == ")" || t.spelling == "]" || t.spelling == "}";
}

}  // namespace

const Token& TokenCursor::peek(std::size_t ahead) const { return tokens_[std::min(at_ + ahead, tokens_.size() - 1)]; }

void TokenCursor::fail_here() const {
  const bool missing_comma = brackets_ > 0 && at_ > 0 && begins_operand(peek()) && ends_operand(tokens_[at_ - 1]);
  fail_syntax(missing_comma ? "invalid syntax. Perhaps you forgot a comma?" : "invalid syntax", peek().line);
}

void TokenCursor::count_link() {
  if (++links_ > kMaxChain) fail_limit("the expression is too long");
}

void TokenCursor::check_name(const std::string& name) {
  if (!name.starts_with("__")) return;
  if (std::find(invalid_.begin(), invalid_.end(), name) == invalid_.end()) invalid_.push_back(name);
}

}  // namespace finemote::gen::expression
