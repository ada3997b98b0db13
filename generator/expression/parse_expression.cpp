// Operators, from the loosest to the tightest, and the whole of an expression.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "generator/expression/grammar.hpp"
#include "generator/expression/number.hpp"

namespace finemote::gen::expression {
namespace {

using Kind = Expression::Kind;

struct Spelled {
  std::string_view symbol;
  Operator op;
};

struct BinaryOperator {
  std::string_view symbol;
  Operator op;
  std::size_t precedence;  // higher binds tighter
};

/// All are left-associative.
constexpr std::array<BinaryOperator, 12> kBinaryOperators = {{{"|", Operator::bit_or, 0},
                                                              {"^", Operator::bit_xor, 1},
                                                              {"&", Operator::bit_and, 2},
                                                              {"<<", Operator::shift_left, 3},
                                                              {">>", Operator::shift_right, 3},
                                                              {"+", Operator::add, 4},
                                                              {"-", Operator::subtract, 4},
                                                              {"*", Operator::multiply, 5},
                                                              {"/", Operator::divide, 5},
                                                              {"//", Operator::floor_divide, 5},
                                                              {"%", Operator::modulo, 5},
                                                              {"@", Operator::matrix_multiply, 5}}};

constexpr std::array<Spelled, 6> kComparisons = {{{"<", Operator::less},
                                                  {"<=", Operator::less_equal},
                                                  {">", Operator::greater},
                                                  {">=", Operator::greater_equal},
                                                  {"==", Operator::equal},
                                                  {"!=", Operator::not_equal}}};

ExpressionPtr parse_lambda(TokenCursor& c) {
  c.expect_word("lambda");
  auto function = make_node(Kind::lambda);
  function->operands.push_back(nullptr);  // the body comes after the defaults
  while (!c.is_symbol(":")) {
    if (c.peek().kind != Token::Kind::name || is_keyword(c.peek().spelling)) c.fail_here();
    function->parameters.emplace_back(c.take().spelling);
    if (c.accept_symbol("=")) {
      function->operands.push_back(parse_value(c));
    } else if (function->operands.size() > 1) {
      fail_syntax("non-default argument follows default argument", c.peek().line);
    }
    if (!c.accept_symbol(",")) break;
  }
  c.expect_symbol(":");
  function->operands[0] = parse_value(c);
  return function;
}

std::optional<Operator> accept_comparison(TokenCursor& c) {
  if (c.peek().kind == Token::Kind::end) return std::nullopt;
  for (const auto& [symbol, op] : kComparisons) {
    if (c.accept_symbol(symbol)) return op;
  }
  if (c.accept_word("in")) return Operator::in;
  if (c.accept_word("is")) return c.accept_word("not") ? Operator::is_not : Operator::is;
  if (c.is_word("not") && c.peek(1).spelling == "in") {
    c.take();
    c.take();
    return Operator::not_in;
  }
  return std::nullopt;
}

ExpressionPtr parse_comparison(TokenCursor& c) {
  auto first = parse_binary(c, 0);
  auto op = accept_comparison(c);
  if (!op) return first;
  auto chain = make_node(Kind::comparison, std::move(first));
  for (; op; op = accept_comparison(c)) {
    chain->operators.push_back(*op);
    chain->operands.push_back(parse_binary(c, 0));
  }
  return chain;
}

ExpressionPtr parse_inversion(TokenCursor& c) {
  if (!c.accept_word("not")) return parse_comparison(c);
  const Level level = c.deeper();
  auto negated = make_node(Kind::unary, parse_inversion(c));
  negated->operators.push_back(Operator::logical_not);
  return negated;
}

ExpressionPtr parse_conjunction(TokenCursor& c) {
  auto first = parse_inversion(c);
  if (!c.is_word("and")) return first;
  auto all = make_node(Kind::logical_and, std::move(first));
  while (c.accept_word("and")) all->operands.push_back(parse_inversion(c));
  return all;
}

const BinaryOperator* next_operator(const TokenCursor& c) {
  if (c.peek().kind != Token::Kind::symbol) return nullptr;
  const auto* found = std::find_if(kBinaryOperators.begin(), kBinaryOperators.end(),
                                   [&](const BinaryOperator& o) { return o.symbol == c.peek().spelling; });
  return found != kBinaryOperators.end() ? found : nullptr;
}

ExpressionPtr parse_unary(TokenCursor& c);

/// `**` binds tighter than a sign on its left, looser than one on its right, and from right to left.
ExpressionPtr parse_power(TokenCursor& c) {
  auto base = parse_primary(c);
  if (!c.accept_symbol("**")) return base;
  const Level level = c.deeper();
  auto raised = make_node(Kind::binary, std::move(base), parse_unary(c));
  raised->operators.push_back(Operator::power);
  return raised;
}

ExpressionPtr parse_unary(TokenCursor& c) {
  constexpr std::array<Spelled, 3> signs = {{{"-", Operator::negate}, {"+", Operator::plus}, {"~", Operator::invert}}};
  for (const auto& [symbol, op] : signs) {
    if (!c.accept_symbol(symbol)) continue;
    const Level level = c.deeper();
    auto signed_value = make_node(Kind::unary, parse_unary(c));
    signed_value->operators.push_back(op);
    return signed_value;
  }
  return parse_power(c);
}

bool begins_value(const TokenCursor& c) {
  const Token& t = c.peek();
  if (t.kind == Token::Kind::symbol) {
    return t.spelling.find_first_of("([{-+~*") == 0;
  }
  if (t.kind == Token::Kind::name && is_keyword(t.spelling)) {
    constexpr std::array<std::string_view, 5> words = {"not", "lambda", "None", "True", "False"};
    return std::find(words.begin(), words.end(), t.spelling) != words.end();
  }
  return t.kind != Token::Kind::end;
}

/// `a` or `a, b` (a tuple).
ExpressionPtr parse_all(TokenCursor& c) {
  auto first = parse_item(c);
  if (!c.is_symbol(",")) return first->kind == Kind::starred ? (c.fail_here(), nullptr) : std::move(first);
  auto tuple = make_node(Kind::tuple, std::move(first));
  while (c.accept_symbol(",")) {
    if (!begins_value(c)) break;
    tuple->operands.push_back(parse_item(c));
  }
  return tuple;
}

}  // namespace

ExpressionPtr parse_value(TokenCursor& c) {
  const Level level = c.deeper();
  if (c.is_word("lambda")) return parse_lambda(c);
  auto value = parse_disjunction(c);
  if (!c.accept_word("if")) return value;
  auto condition = parse_disjunction(c);
  if (!c.is_word("else")) fail_syntax("expected 'else' after 'if' expression", c.peek().line);
  c.expect_word("else");
  auto otherwise = parse_value(c);
  return make_node(Kind::conditional, std::move(value), std::move(condition), std::move(otherwise));
}

ExpressionPtr parse_item(TokenCursor& c) {
  if (c.accept_symbol("*")) return make_node(Kind::starred, parse_binary(c, 0));
  return parse_value(c);
}

ExpressionPtr parse_disjunction(TokenCursor& c) {
  auto first = parse_conjunction(c);
  if (!c.is_word("or")) return first;
  auto all = make_node(Kind::logical_or, std::move(first));
  while (c.accept_word("or")) all->operands.push_back(parse_conjunction(c));
  return all;
}

ExpressionPtr parse_binary(TokenCursor& c, std::size_t precedence) {
  auto left = parse_unary(c);
  for (const BinaryOperator* next = next_operator(c); next != nullptr && next->precedence >= precedence;
       next = next_operator(c)) {
    c.take();
    left = make_node(Kind::binary, std::move(left), parse_binary(c, next->precedence + 1));
    left->operators.push_back(next->op);
    c.count_link();
  }
  return left;
}

ExpressionPtr parse_expression(std::string_view source) {
  TokenCursor c(stripped(source));
  if (c.is_end()) fail_syntax("invalid syntax", 0);
  auto expression = parse_all(c);
  if (!c.is_end()) c.fail_here();
  if (!c.invalid_names().empty()) {
    fail_eval(fmt::format("Use of invalid name(s):  {}", fmt::join(c.invalid_names(), ", ")));
  }
  return expression;
}

}  // namespace finemote::gen::expression
