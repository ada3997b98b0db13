#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "generator/expression/budget.hpp"
#include "generator/expression/expression.hpp"
#include "generator/expression/number.hpp"
#include "generator/expression/token.hpp"

namespace finemote::gen::expression {
namespace {

using Kind = Expression::Kind;

ExpressionPtr make(Kind kind) {
  auto e = std::make_unique<Expression>();
  e->kind = kind;
  return e;
}

template <typename... Operands>
ExpressionPtr make(Kind kind, ExpressionPtr first, Operands... rest) {
  auto e = make(kind);
  e->operands.reserve(1 + sizeof...(rest));
  e->operands.push_back(std::move(first));
  (e->operands.push_back(std::move(rest)), ...);
  return e;
}

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

class Parser {
 public:
  explicit Parser(std::string_view source) : tokens_(tokenize_expression(source)) {}

  ExpressionPtr run() {
    if (peek().kind == Token::Kind::end) fail_syntax("invalid syntax", 0);
    auto expression = expressions();
    if (peek().kind != Token::Kind::end) fail_here();
    return expression;
  }

 private:
  [[nodiscard]] const Token& peek(std::size_t ahead = 0) const {
    return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
  }
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

  [[noreturn]] void fail_here() const {
    const bool missing_comma = brackets_ > 0 && at_ > 0 && begins_operand(peek()) && ends_operand(tokens_[at_ - 1]);
    fail_syntax(missing_comma ? "invalid syntax. Perhaps you forgot a comma?" : "invalid syntax", peek().line);
  }

  static bool begins_operand(const Token& t) {
    if (t.kind == Token::Kind::name) return !is_keyword(t.spelling) || t.spelling == "True" || t.spelling == "False";
    return t.kind == Token::Kind::number || t.kind == Token::Kind::text;
  }
  static bool ends_operand(const Token& t) {
    return begins_operand(t) || t.spelling == ")" || t.spelling == "]" || t.spelling == "}";
  }

  Level deeper() { return Level(depth_, kMaxExpressionDepth, "too many nested parentheses"); }

  /// `a` or `a, b` (a tuple).
  ExpressionPtr expressions() {
    auto first = item();
    if (!is_symbol(",")) return first->kind == Kind::starred ? (fail_here(), nullptr) : std::move(first);
    auto tuple = make(Kind::tuple, std::move(first));
    while (accept_symbol(",")) {
      if (!begins_expression()) break;
      tuple->operands.push_back(item());
    }
    return tuple;
  }

  /// An item of a display: an expression or `*iterable`.
  ExpressionPtr item() {
    if (accept_symbol("*")) return make(Kind::starred, binary(0));
    return expression();
  }

  [[nodiscard]] bool begins_expression() const {
    const Token& t = peek();
    if (t.kind == Token::Kind::symbol) {
      return t.spelling.find_first_of("([{-+~*") == 0;
    }
    if (t.kind == Token::Kind::name && is_keyword(t.spelling)) {
      constexpr std::array<std::string_view, 5> words = {"not", "lambda", "None", "True", "False"};
      return std::find(words.begin(), words.end(), t.spelling) != words.end();
    }
    return t.kind != Token::Kind::end;
  }

  ExpressionPtr expression() {
    const Level level = deeper();
    if (is_word("lambda")) return lambda();
    auto value = disjunction();
    if (!accept_word("if")) return value;
    auto condition = disjunction();
    if (!is_word("else")) fail_syntax("expected 'else' after 'if' expression", peek().line);
    expect_word("else");
    auto otherwise = expression();
    return make(Kind::conditional, std::move(value), std::move(condition), std::move(otherwise));
  }

  ExpressionPtr lambda() {
    expect_word("lambda");
    auto function = make(Kind::lambda);
    function->operands.push_back(nullptr);  // the body comes after the defaults
    while (!is_symbol(":")) {
      if (peek().kind != Token::Kind::name || is_keyword(peek().spelling)) fail_here();
      function->parameters.emplace_back(tokens_[at_++].spelling);
      if (accept_symbol("=")) {
        function->operands.push_back(expression());
      } else if (function->operands.size() > 1) {
        fail_syntax("non-default argument follows default argument", peek().line);
      }
      if (!accept_symbol(",")) break;
    }
    expect_symbol(":");
    function->operands[0] = expression();
    return function;
  }

  ExpressionPtr disjunction() {
    auto first = conjunction();
    if (!is_word("or")) return first;
    auto all = make(Kind::logical_or, std::move(first));
    while (accept_word("or")) all->operands.push_back(conjunction());
    return all;
  }

  ExpressionPtr conjunction() {
    auto first = inversion();
    if (!is_word("and")) return first;
    auto all = make(Kind::logical_and, std::move(first));
    while (accept_word("and")) all->operands.push_back(inversion());
    return all;
  }

  ExpressionPtr inversion() {
    if (!accept_word("not")) return comparison();
    const Level level = deeper();
    auto negated = make(Kind::unary, inversion());
    negated->operators.push_back(Operator::logical_not);
    return negated;
  }

  ExpressionPtr comparison() {
    auto first = binary(0);
    auto op = comparison_operator();
    if (!op) return first;
    auto chain = make(Kind::comparison, std::move(first));
    for (; op; op = comparison_operator()) {
      chain->operators.push_back(*op);
      chain->operands.push_back(binary(0));
    }
    return chain;
  }

  std::optional<Operator> comparison_operator() {
    if (peek().kind == Token::Kind::end) return std::nullopt;
    for (const auto& [symbol, op] : kComparisons) {
      if (accept_symbol(symbol)) return op;
    }
    if (accept_word("in")) return Operator::in;
    if (accept_word("is")) return accept_word("not") ? Operator::is_not : Operator::is;
    if (is_word("not") && peek(1).spelling == "in") {
      at_ += 2;
      return Operator::not_in;
    }
    return std::nullopt;
  }

  /// Operands joined by operators that bind at least as tight as `precedence`.
  ExpressionPtr binary(std::size_t precedence) {
    auto left = unary();
    for (const BinaryOperator* next = binary_operator(); next != nullptr && next->precedence >= precedence;
         next = binary_operator()) {
      ++at_;
      left = make(Kind::binary, std::move(left), binary(next->precedence + 1));
      left->operators.push_back(next->op);
      if (++chained_ > kMaxChain) fail_limit("the expression is too long");
    }
    return left;
  }

  [[nodiscard]] const BinaryOperator* binary_operator() const {
    if (peek().kind != Token::Kind::symbol) return nullptr;
    const auto* found = std::find_if(kBinaryOperators.begin(), kBinaryOperators.end(),
                                     [&](const BinaryOperator& o) { return o.symbol == peek().spelling; });
    return found != kBinaryOperators.end() ? found : nullptr;
  }

  ExpressionPtr unary() {
    constexpr std::array<Spelled, 3> signs = {
        {{"-", Operator::negate}, {"+", Operator::plus}, {"~", Operator::invert}}};
    for (const auto& [symbol, op] : signs) {
      if (!accept_symbol(symbol)) continue;
      const Level level = deeper();
      auto signed_value = make(Kind::unary, unary());
      signed_value->operators.push_back(op);
      return signed_value;
    }
    return power();
  }

  /// `**` binds tighter than a sign on its left, looser than one on its right, and from right to left.
  ExpressionPtr power() {
    auto base = primary();
    if (!accept_symbol("**")) return base;
    const Level level = deeper();
    auto raised = make(Kind::binary, std::move(base), unary());
    raised->operators.push_back(Operator::power);
    return raised;
  }

  ExpressionPtr primary() {
    auto value = atom();
    for (;;) {
      if (accept_symbol(".")) {
        if (peek().kind != Token::Kind::name || is_keyword(peek().spelling)) fail_here();
        value = make(Kind::attribute, std::move(value));
        value->name = tokens_[at_++].spelling;
        check_name(value->name);
      } else if (accept_symbol("(")) {
        value = call(std::move(value));
      } else if (accept_symbol("[")) {
        ++brackets_;
        value = make(Kind::subscript, std::move(value), subscript());
        expect_symbol("]");
        --brackets_;
      } else {
        return value;
      }
      if (++chained_ > kMaxChain) fail_limit("the expression is too long");
    }
  }

  ExpressionPtr call(ExpressionPtr function) {
    ++brackets_;
    auto call = make(Kind::call, std::move(function));
    while (!is_symbol(")")) {
      argument(*call);
      if (!accept_symbol(",")) break;
    }
    expect_symbol(")");
    --brackets_;
    return call;
  }

  void argument(Expression& call) {
    if (accept_symbol("**")) {
      call.keywords.push_back({{}, expression()});
      return;
    }
    if (accept_symbol("*")) {
      call.operands.push_back(make(Kind::starred, expression()));
      return;
    }
    if (peek().kind == Token::Kind::name && peek(1).kind == Token::Kind::symbol && peek(1).spelling == "=") {
      if (is_keyword(peek().spelling)) fail_here();
      std::string name(peek().spelling);
      at_ += 2;
      call.keywords.push_back({std::move(name), expression()});
      return;
    }
    auto value = expression();
    if (is_word("for")) value = comprehension(Kind::generator, std::move(value));
    if (!call.keywords.empty()) fail_syntax("positional argument follows keyword argument", peek().line);
    call.operands.push_back(std::move(value));
  }

  ExpressionPtr subscript() {
    auto first = slice();
    if (!is_symbol(",")) return first;
    auto tuple = make(Kind::tuple, std::move(first));
    while (accept_symbol(",") && !is_symbol("]")) tuple->operands.push_back(slice());
    return tuple;
  }

  ExpressionPtr slice() {
    const auto bound = [this] { return is_symbol(":") || is_symbol("]") || is_symbol(",") ? nullptr : expression(); };
    auto start = bound();
    if (!accept_symbol(":")) return start ? std::move(start) : (fail_here(), nullptr);
    auto stop = bound();
    auto step = accept_symbol(":") ? bound() : nullptr;
    return make(Kind::slice, std::move(start), std::move(stop), std::move(step));
  }

  ExpressionPtr atom() {
    const Token& token = peek();
    if (token.kind == Token::Kind::number) return constant(tokens_[at_++].value);
    if (token.kind == Token::Kind::text) return text();
    if (token.kind == Token::Kind::name) return name();
    if (accept_symbol("(")) return bracketed([this] { return parenthesis(); });
    if (accept_symbol("[")) return bracketed([this] { return list(); });
    if (accept_symbol("{")) return bracketed([this] { return braces(); });
    fail_here();
  }

  template <typename Inner>
  ExpressionPtr bracketed(Inner inner) {
    const Level level = deeper();
    ++brackets_;
    auto value = inner();
    --brackets_;
    return value;
  }

  static ExpressionPtr constant(Value value) {
    auto e = make(Kind::constant);
    e->value = std::move(value);
    return e;
  }

  /// Neighbouring texts are one.
  ExpressionPtr text() {
    std::string joined;
    while (peek().kind == Token::Kind::text) joined += *tokens_[at_++].value.text();
    return constant(std::move(joined));
  }

  ExpressionPtr name() {
    const std::string_view word = peek().spelling;
    if (word == "True" || word == "False") return ++at_, constant(word == "True");
    if (word == "None") return ++at_, constant({});
    if (is_keyword(word)) fail_here();
    ++at_;
    auto e = make(Kind::name);
    e->name = word;
    check_name(e->name);
    return e;
  }

  ExpressionPtr parenthesis() {
    if (accept_symbol(")")) return make(Kind::tuple);
    auto first = item();
    if (is_word("for")) {
      first = comprehension(Kind::generator, std::move(first));
    } else if (is_symbol(",")) {
      first = make(Kind::tuple, std::move(first));
      items(*first, ")");
    }
    if (first->kind == Kind::starred) fail_syntax("cannot use starred expression here", peek().line);
    expect_symbol(")");
    return first;
  }

  /// `, b, c` up to the closing bracket.
  void items(Expression& display, std::string_view closer) {
    while (accept_symbol(",") && !is_symbol(closer)) display.operands.push_back(item());
  }

  ExpressionPtr list() {
    if (accept_symbol("]")) return make(Kind::list);
    auto first = item();
    if (is_word("for")) {
      first = comprehension(Kind::list_of, std::move(first));
    } else {
      first = make(Kind::list, std::move(first));
      items(*first, "]");
    }
    expect_symbol("]");
    return first;
  }

  ExpressionPtr braces() {
    if (accept_symbol("}")) return make(Kind::dict);
    auto first = item();
    auto display = is_symbol(":") ? dict(std::move(first)) : set(std::move(first));
    expect_symbol("}");
    return display;
  }

  ExpressionPtr set(ExpressionPtr first) {
    if (is_word("for")) return comprehension(Kind::set_of, std::move(first));
    auto display = make(Kind::set, std::move(first));
    items(*display, "}");
    return display;
  }

  ExpressionPtr dict(ExpressionPtr key) {
    expect_symbol(":");
    auto display = make(Kind::dict, std::move(key), expression());
    if (is_word("for")) {
      auto of = comprehension(Kind::dict_of, std::move(display->operands[0]));
      of->operands.push_back(std::move(display->operands[1]));
      return of;
    }
    while (accept_symbol(",") && !is_symbol("}")) {
      display->operands.push_back(expression());
      expect_symbol(":");
      display->operands.push_back(expression());
    }
    return display;
  }

  ExpressionPtr comprehension(Kind kind, ExpressionPtr element) {
    auto of = make(kind, std::move(element));
    while (accept_word("for")) {
      Clause clause;
      clause.target = targets();
      expect_word("in");
      clause.items = disjunction();
      while (accept_word("if")) clause.conditions.push_back(disjunction());
      of->clauses.push_back(std::move(clause));
    }
    return of;
  }

  ExpressionPtr targets() {
    auto first = target();
    if (!is_symbol(",")) return first;
    auto tuple = make(Kind::tuple, std::move(first));
    while (accept_symbol(",") && !is_word("in")) tuple->operands.push_back(target());
    return tuple;
  }

  ExpressionPtr target() {
    const Level level = deeper();
    for (const auto& [open, close] : {std::pair("(", ")"), std::pair("[", "]")}) {
      if (!accept_symbol(open)) continue;
      auto inner = targets();
      expect_symbol(close);
      return inner;
    }
    if (peek().kind != Token::Kind::name) fail_here();
    return name();
  }

  void check_name(const std::string& name) {
    if (!name.starts_with("__")) return;
    if (std::find(invalid_.begin(), invalid_.end(), name) == invalid_.end()) invalid_.push_back(name);
  }

 public:
  /// Names that no expression may use, in the order they appear.
  [[nodiscard]] const std::vector<std::string>& invalid_names() const { return invalid_; }

 private:
  static constexpr std::size_t kMaxChain = 2'000;  // a chain is a tree as deep as it is long
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  std::size_t brackets_ = 0;
  std::size_t depth_ = 0;
  std::size_t chained_ = 0;
  std::vector<std::string> invalid_;
};

}  // namespace

ExpressionPtr parse_expression(std::string_view source) {
  Parser parser(stripped(source));
  auto expression = parser.run();
  if (!parser.invalid_names().empty()) {
    fail_eval(fmt::format("Use of invalid name(s):  {}", fmt::join(parser.invalid_names(), ", ")));
  }
  return expression;
}

}  // namespace finemote::gen::expression
