// Text of a C++ file to the functions and classes it defines, with the lines each takes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace finemote::test {

enum class DefinitionKind { function, type };

/// From the first word of the declaration (its `template`, where it has one) to the closing brace. What stands in a
/// function, lambdas and local classes, is part of it; a lambda outside of functions is a function of its own, with the
/// name of what it initialises.
struct Definition {
  DefinitionKind kind = DefinitionKind::function;
  std::string name;  ///< as written where it is defined: `Lexer::run`, `operator==`, `Lexer`; empty without one
  int first_line = 0;
  int last_line = 0;

  [[nodiscard]] int lines() const { return last_line - first_line + 1; }
};

/// In the order in which they end: a class comes after the functions in it.
/// @throws std::runtime_error  braces or parentheses do not match, as in the two sides of an `#else` that share one
std::vector<Definition> definitions_in(std::string_view text);

}  // namespace finemote::test
