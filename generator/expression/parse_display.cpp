// What begins with a bracket: tuples, lists, sets, dicts and comprehensions.
#include <string_view>
#include <utility>

#include "generator/expression/grammar.hpp"

namespace finemote::gen::expression {
namespace {

using Kind = Expression::Kind;

ExpressionPtr parse_target(TokenCursor& c);

/// `, b, c` up to the closing bracket.
void parse_items(TokenCursor& c, Expression& display, std::string_view closer) {
  while (c.accept_symbol(",") && !c.is_symbol(closer)) display.operands.push_back(parse_item(c));
}

ExpressionPtr parse_parenthesis(TokenCursor& c) {
  if (c.accept_symbol(")")) return make_node(Kind::tuple);
  auto first = parse_item(c);
  if (c.is_word("for")) {
    first = parse_comprehension(c, Kind::generator, std::move(first));
  } else if (c.is_symbol(",")) {
    first = make_node(Kind::tuple, std::move(first));
    parse_items(c, *first, ")");
  }
  if (first->kind == Kind::starred) fail_syntax("cannot use starred expression here", c.peek().line);
  c.expect_symbol(")");
  return first;
}

ExpressionPtr parse_list(TokenCursor& c) {
  if (c.accept_symbol("]")) return make_node(Kind::list);
  auto first = parse_item(c);
  if (c.is_word("for")) {
    first = parse_comprehension(c, Kind::list_of, std::move(first));
  } else {
    first = make_node(Kind::list, std::move(first));
    parse_items(c, *first, "]");
  }
  c.expect_symbol("]");
  return first;
}

ExpressionPtr parse_set(TokenCursor& c, ExpressionPtr first) {
  if (c.is_word("for")) return parse_comprehension(c, Kind::set_of, std::move(first));
  auto display = make_node(Kind::set, std::move(first));
  parse_items(c, *display, "}");
  return display;
}

ExpressionPtr parse_dict(TokenCursor& c, ExpressionPtr key) {
  c.expect_symbol(":");
  auto display = make_node(Kind::dict, std::move(key), parse_value(c));
  if (c.is_word("for")) {
    auto of = parse_comprehension(c, Kind::dict_of, std::move(display->operands[0]));
    of->operands.push_back(std::move(display->operands[1]));
    return of;
  }
  while (c.accept_symbol(",") && !c.is_symbol("}")) {
    display->operands.push_back(parse_value(c));
    c.expect_symbol(":");
    display->operands.push_back(parse_value(c));
  }
  return display;
}

ExpressionPtr parse_braces(TokenCursor& c) {
  if (c.accept_symbol("}")) return make_node(Kind::dict);
  auto first = parse_item(c);
  auto display = c.is_symbol(":") ? parse_dict(c, std::move(first)) : parse_set(c, std::move(first));
  c.expect_symbol("}");
  return display;
}

ExpressionPtr parse_targets(TokenCursor& c) {
  auto first = parse_target(c);
  if (!c.is_symbol(",")) return first;
  auto tuple = make_node(Kind::tuple, std::move(first));
  while (c.accept_symbol(",") && !c.is_word("in")) tuple->operands.push_back(parse_target(c));
  return tuple;
}

ExpressionPtr parse_target(TokenCursor& c) {
  const Level level = c.deeper();
  for (const auto& [open, close] : {std::pair("(", ")"), std::pair("[", "]")}) {
    if (!c.accept_symbol(open)) continue;
    auto inner = parse_targets(c);
    c.expect_symbol(close);
    return inner;
  }
  if (c.peek().kind != Token::Kind::name) c.fail_here();
  return parse_name(c);
}

/// What follows an opening bracket.
ExpressionPtr bracketed(TokenCursor& c, ExpressionPtr (*inner)(TokenCursor& c)) {
  const Level level = c.deeper();
  const TokenCursor::Brackets inside(c);
  return inner(c);
}

}  // namespace

ExpressionPtr parse_display(TokenCursor& c) {
  if (c.accept_symbol("(")) return bracketed(c, parse_parenthesis);
  if (c.accept_symbol("[")) return bracketed(c, parse_list);
  if (c.accept_symbol("{")) return bracketed(c, parse_braces);
  return nullptr;
}

ExpressionPtr parse_comprehension(TokenCursor& c, Kind kind, ExpressionPtr element) {
  auto of = make_node(kind, std::move(element));
  while (c.accept_word("for")) {
    Clause clause;
    clause.target = parse_targets(c);
    c.expect_word("in");
    clause.items = parse_disjunction(c);
    while (c.accept_word("if")) clause.conditions.push_back(parse_disjunction(c));
    of->clauses.push_back(std::move(clause));
  }
  return of;
}

}  // namespace finemote::gen::expression
