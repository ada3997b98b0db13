// The text of an expression cut into Python's tokens.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

struct Token {
  enum class Kind { name, number, text, symbol, end };
  Kind kind = Kind::end;
  std::string_view spelling;  ///< name, keyword or symbol; a view into the source
  Value value;                ///< of numbers and texts
  std::size_t line = 1;
};

/// Fails with the words of Python's tokenizer: "unterminated string literal ...".
/// A line break counts only inside brackets; outside, it is an error.
std::vector<Token> tokenize_expression(std::string_view source);

/// Throws "MESSAGE (<expression>, line N)".
[[noreturn]] void fail_syntax(std::string_view message, std::size_t line);

/// A Python keyword: it can be no name.
bool is_keyword(std::string_view word);

/// A name of letters, digits and '_' that does not begin with a digit and is no keyword. Characters beyond ASCII count
/// as letters.
bool is_identifier(std::string_view word);

}  // namespace finemote::gen::expression
