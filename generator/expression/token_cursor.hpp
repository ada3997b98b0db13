// The tokens of an expression, taken from left to right.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "generator/expression/budget.hpp"
#include "generator/expression/token.hpp"

namespace finemote::gen::expression {

/// Also keeps what the rules share: how deep they stand, and which names no expression may use.
class TokenCursor {
 public:
  explicit TokenCursor(std::string_view source) : tokens_(tokenize_expression(source)) {}

  /// The next token, or one after it; past the last one, the end token.
  [[nodiscard]] const Token& peek(std::size_t ahead = 0) const;
  const Token& take() { return tokens_[at_++]; }

  [[nodiscard]] bool is_end() const { return peek().kind == Token::Kind::end; }
  [[nodiscard]] bool is_symbol(std::string_view s) const {
    return peek().kind == Token::Kind::symbol && peek().spelling == s;
  }
  [[nodiscard]] bool is_word(std::string_view w) const {
    return peek().kind == Token::Kind::name && peek().spelling == w;
  }
  bool accept_symbol(std::string_view s) { return is_symbol(s) && (++at_, true); }
  bool accept_word(std::string_view w) { return is_word(w) && (++at_, true); }
  void expect_symbol(std::string_view s) {
    if (!accept_symbol(s)) fail_here();
  }
  void expect_word(std::string_view w) {
    if (!accept_word(w)) fail_here();
  }
  /// "invalid syntax", with a guess where two operands meet.
  [[noreturn]] void fail_here() const;

  /// One level deeper; fails when there are too many.
  [[nodiscard]] Level deeper() { return Level(depth_, kMaxExpressionDepth, "too many nested parentheses"); }
  /// Counts a link of a chain like a.b.c or a+b+c; fails when there are too many.
  void count_link();

  /// Inside brackets as long as it lives.
  class [[nodiscard]] Brackets {
   public:
    explicit Brackets(TokenCursor& c) : count_(c.brackets_) { ++count_; }
    ~Brackets() { --count_; }
    Brackets(const Brackets&) = delete;
    Brackets& operator=(const Brackets&) = delete;

   private:
    std::size_t& count_;
  };

  /// Notes a name that begins with two underscores.
  void check_name(const std::string& name);
  /// Names that no expression may use, in the order they appear.
  [[nodiscard]] const std::vector<std::string>& invalid_names() const { return invalid_; }

 private:
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  std::size_t brackets_ = 0;  // open
  std::size_t depth_ = 0;
  std::size_t links_ = 0;
  std::vector<std::string> invalid_;
};

}  // namespace finemote::gen::expression
