// A value with its calls, attributes and subscripts, and the smallest values: names, numbers, texts.
#include "generator/expression/grammar.hpp"

namespace finemote::gen::expression {
namespace {

using Kind = Expression::Kind;

ExpressionPtr constant(Value value) {
  auto e = make_node(Kind::constant);
  e->value = std::move(value);
  return e;
}

/// Neighbouring texts are one.
ExpressionPtr parse_text(TokenCursor& c) {
  std::string joined;
  while (c.peek().kind == Token::Kind::text) joined += *c.take().value.text();
  return constant(std::move(joined));
}

ExpressionPtr parse_atom(TokenCursor& c) {
  const Token& token = c.peek();
  if (token.kind == Token::Kind::number) return constant(c.take().value);
  if (token.kind == Token::Kind::text) return parse_text(c);
  if (token.kind == Token::Kind::name) return parse_name(c);
  if (auto display = parse_display(c)) return display;
  c.fail_here();
}

void parse_argument(TokenCursor& c, Expression& call) {
  if (c.accept_symbol("**")) {
    call.keywords.push_back({{}, parse_value(c)});
    return;
  }
  if (c.accept_symbol("*")) {
    call.operands.push_back(make_node(Kind::starred, parse_value(c)));
    return;
  }
  if (c.peek().kind == Token::Kind::name && c.peek(1).kind == Token::Kind::symbol && c.peek(1).spelling == "=") {
    if (is_keyword(c.peek().spelling)) c.fail_here();
    std::string keyword(c.peek().spelling);
    c.take();
    c.take();
    call.keywords.push_back({std::move(keyword), parse_value(c)});
    return;
  }
  auto value = parse_value(c);
  if (c.is_word("for")) value = parse_comprehension(c, Kind::generator, std::move(value));
  if (!call.keywords.empty()) fail_syntax("positional argument follows keyword argument", c.peek().line);
  call.operands.push_back(std::move(value));
}

ExpressionPtr parse_call(TokenCursor& c, ExpressionPtr function) {
  const TokenCursor::Brackets inside(c);
  auto call = make_node(Kind::call, std::move(function));
  while (!c.is_symbol(")")) {
    parse_argument(c, *call);
    if (!c.accept_symbol(",")) break;
  }
  c.expect_symbol(")");
  return call;
}

ExpressionPtr parse_slice(TokenCursor& c) {
  const auto bound = [&c] {
    return c.is_symbol(":") || c.is_symbol("]") || c.is_symbol(",") ? nullptr : parse_value(c);
  };
  auto start = bound();
  if (!c.accept_symbol(":")) return start ? std::move(start) : (c.fail_here(), nullptr);
  auto stop = bound();
  auto step = c.accept_symbol(":") ? bound() : nullptr;
  return make_node(Kind::slice, std::move(start), std::move(stop), std::move(step));
}

ExpressionPtr parse_subscript(TokenCursor& c) {
  auto first = parse_slice(c);
  if (!c.is_symbol(",")) return first;
  auto tuple = make_node(Kind::tuple, std::move(first));
  while (c.accept_symbol(",") && !c.is_symbol("]")) tuple->operands.push_back(parse_slice(c));
  return tuple;
}

}  // namespace

ExpressionPtr parse_primary(TokenCursor& c) {
  auto value = parse_atom(c);
  for (;;) {
    if (c.accept_symbol(".")) {
      if (c.peek().kind != Token::Kind::name || is_keyword(c.peek().spelling)) c.fail_here();
      value = make_node(Kind::attribute, std::move(value));
      value->name = c.take().spelling;
      c.check_name(value->name);
    } else if (c.accept_symbol("(")) {
      value = parse_call(c, std::move(value));
    } else if (c.accept_symbol("[")) {
      const TokenCursor::Brackets inside(c);
      value = make_node(Kind::subscript, std::move(value), parse_subscript(c));
      c.expect_symbol("]");
    } else {
      return value;
    }
    c.count_link();
  }
}

ExpressionPtr parse_name(TokenCursor& c) {
  const std::string_view word = c.peek().spelling;
  if (word == "True" || word == "False") return c.take(), constant(word == "True");
  if (word == "None") return c.take(), constant({});
  if (is_keyword(word)) c.fail_here();
  c.take();
  auto e = make_node(Kind::name);
  e->name = word;
  c.check_name(e->name);
  return e;
}

}  // namespace finemote::gen::expression
