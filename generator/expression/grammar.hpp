// The rules of Python's grammar that refer to each other across files. Each takes its tokens and gives their tree.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>

#include "generator/expression/expression.hpp"
#include "generator/expression/token_cursor.hpp"

namespace finemote::gen::expression {

/// An expression without commas around it: `a if b else c`, `lambda x: x`, `a or b` ...
ExpressionPtr parse_value(TokenCursor& c);
/// An item of a display: a value or `*iterable`.
ExpressionPtr parse_item(TokenCursor& c);
/// `a or b` and all that binds tighter.
ExpressionPtr parse_disjunction(TokenCursor& c);
/// Operands joined by operators that bind at least as tight as `precedence`: 0 for all but comparisons.
ExpressionPtr parse_binary(TokenCursor& c, std::size_t precedence);
/// A value with its calls, attributes and subscripts.
ExpressionPtr parse_primary(TokenCursor& c);
/// A name that may be used, or None, True, False.
ExpressionPtr parse_name(TokenCursor& c);
/// What begins with a bracket: a tuple, list, set, dict or comprehension; null when none does.
ExpressionPtr parse_display(TokenCursor& c);
/// `for a in b if c ...` after its element.
ExpressionPtr parse_comprehension(TokenCursor& c, Expression::Kind kind, ExpressionPtr element);

inline ExpressionPtr make_node(Expression::Kind kind) {
  auto e = std::make_unique<Expression>();
  e->kind = kind;
  return e;
}

template <typename... Operands>
ExpressionPtr make_node(Expression::Kind kind, ExpressionPtr first, Operands... rest) {
  auto e = make_node(kind);
  e->operands.reserve(1 + sizeof...(rest));
  e->operands.push_back(std::move(first));
  (e->operands.push_back(std::move(rest)), ...);
  return e;
}

}  // namespace finemote::gen::expression
