// Text of a C++ file as its words and signs, each with its line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace finemote::test {

/// A name, a number, a sign (`::` and `->` are one, all others are one character each), or a literal, whose text is
/// `""`, `''` for a character.
struct Token {
  std::string text;
  int line = 1;           ///< where it begins, from 1
  std::string literal{};  ///< of a literal: what stands in its quotes, as written
};

/// What the compiler would see of a file whose macros nobody expands: comments and preprocessor lines are left out.
/// Both sides of an `#else` are kept.
std::vector<Token> tokens_of(std::string_view text);

}  // namespace finemote::test
