#include "generator/xacro/text_evaluator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <new>

#include "generator/xacro/limits.hpp"

namespace finemote::gen::xacro {
namespace {

/// What a message shows of an expression, which can be as long as the file.
std::string excerpt(const std::string& text) {
  constexpr std::size_t most = 300;
  if (text.size() <= most) return text;
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // not inside a character
  return text.substr(0, end) + " ...";
}

/// Says where a failure inside a piece comes from.
void add_place(Failure& failure, const Piece& piece, const Position& text_at, const Position& piece_at) {
  if (piece.kind == Piece::Kind::expression) {
    failure.message += fmt::format(" when evaluating expression '{}'", excerpt(piece.text));
  }
  const bool is_elsewhere =
      failure.at.file != nullptr && (failure.at.file != text_at.file || failure.at.line != text_at.line);
  constexpr std::size_t most_notes = 8;
  if (failure.at.file == nullptr) {
    failure.at = piece_at;
  } else if (is_elsewhere && failure.notes.size() < most_notes) {
    failure.notes.push_back({fmt::format("needed for '{}'", excerpt(piece.text)), piece_at});
  }
}

/// Puts a value back at the end of a block.
template <typename T>
class Restored {
 public:
  Restored(T& place, T value) : place_(place), before_(std::exchange(place, std::move(value))) {}
  ~Restored() { place_ = std::move(before_); }
  Restored(const Restored&) = delete;
  Restored& operator=(const Restored&) = delete;

 private:
  T& place_;
  T before_;
};

}  // namespace

std::string TextEvaluator::text_of(const std::string& text, const Position& at, Scope& scope) {
  if (text.find('$') == std::string::npos) return text;
  const Text& cut = cut_of(text);
  if (depth_ == 0) runtime_.budget.begin_expression();
  return joined(cut, {text, at, scope});
}

Value TextEvaluator::value_of(const std::string& text, const Position& at, Scope& scope) {
  if (text.find('$') == std::string::npos) return text;
  const Text& cut = cut_of(text);
  if (depth_ == 0) runtime_.budget.begin_expression();
  return evaluate(cut, {text, at, scope});
}

/// The text cut once for all its uses.
const Text& TextEvaluator::cut_of(const std::string& text) {
  auto& cut = texts_[text];
  if (!cut) cut = std::make_unique<const Text>(cut_text(text));
  return *cut;
}

/// A text that is one expression has the expression's value; all others are text.
Value TextEvaluator::evaluate(const Text& text, const Subject& subject) {
  if (text.pieces.size() != 1) return joined(text, subject);
  check_piece(text, 0, subject);
  return evaluate_piece(text.pieces[0], subject);
}

/// A limit that strikes while values become text has no place of its own.
std::string TextEvaluator::joined(const Text& text, const Subject& subject) {
  try {
    return pieces_of(text, subject);
  } catch (Failure& failure) {
    if (failure.at.file == nullptr) failure.at = subject.at;
    throw;
  }
}

std::string TextEvaluator::pieces_of(const Text& text, const Subject& subject) {
  if (text.pieces.size() == 1) return to_text(runtime_, evaluate(text, subject));
  check_piece(text, 0, subject);
  std::string joined;
  for (std::size_t i = 0; i < text.pieces.size(); ++i) {
    check_piece(text, i + 1, subject);  // before this piece is evaluated, as ROS xacro reads one piece ahead
    const Piece& piece = text.pieces[i];
    joined += piece.kind == Piece::Kind::plain ? piece.text : to_text(runtime_, evaluate_piece(piece, subject));
    if (joined.size() > expression::kMaxText) fail_limit("the text is too long");
  }
  runtime_.budget.spend(joined.size() / 16);
  return joined;
}

/// Fails if piece `i` is an opening bracket without its closing one.
void TextEvaluator::check_piece(const Text& text, std::size_t i, const Subject& subject) {
  if (i >= text.pieces.size() || text.pieces[i].kind != Piece::Kind::malformed) return;
  const Piece& piece = text.pieces[i];
  std::vector<std::string> hints;
  if (piece.text.starts_with("${")) hints.push_back("close it with '}'; for the text itself write '$${'");
  if (piece.text.starts_with("$(")) hints.push_back("close it with ')'; for the text itself write '$$('");
  throw Failure{
      code::xacro_text, "invalid expression: " + excerpt(piece.text), subject.place(piece), {}, std::move(hints)};
}

Value TextEvaluator::evaluate_piece(const Piece& piece, const Subject& subject) {
  if (piece.kind == Piece::Kind::plain) return piece.text;
  const Level level(depth_, kMaxNestedCalls, "maximum recursion depth exceeded in expressions");
  const Restored current(current_, CurrentPiece{subject.at, &subject.words, piece.offset});
  try {
    if (piece.kind == Piece::Kind::expression) return evaluate_expression(piece, subject);
    return evaluate_substitution(inner_of(piece, subject));
  } catch (Failure& failure) {
    add_place(failure, piece, subject.at, subject.place(piece));
    throw;
  } catch (const std::bad_alloc&) {
    throw Failure{code::xacro_limit, "the expression needs more memory than there is", subject.place(piece)};
  }
}

std::string TextEvaluator::inner_of(const Piece& piece, const Subject& subject) {
  return piece.inner ? joined(*piece.inner, subject) : piece.text;
}

Value TextEvaluator::evaluate_expression(const Piece& piece, const Subject& subject) {
  if (piece.inner) return evaluate_source(inner_of(piece, subject), subject.scope);
  if (!piece.compiled) piece.compiled = expression::parse_expression(piece.text);
  return expression::evaluate(runtime_, *piece.compiled, subject.scope);
}

std::string TextEvaluator::evaluate_substitution(const std::string& inside) {
  constexpr std::string_view eval = "eval ";
  return inside.starts_with(eval) ? evaluate_with_arguments(inside.substr(eval.size())) : substitute(world_, inside);
}

/// $(eval): an expression that sees the arguments, as numbers and booleans where their texts are.
std::string TextEvaluator::evaluate_with_arguments(const std::string& expression) {
  if (expression.find("__") != std::string::npos) {
    fail(code::xacro_substitution, "$(eval ...) may not contain double underscore expressions");
  }
  Scope scope(Scope::Kind::builtins, nullptr);
  for (const auto& [name, value] : arguments_.ask_for(expression)) {
    scope.set(name, {expression::argument_literal(value), false, {}});
  }
  expression::add_eval_symbols(scope);
  return to_text(runtime_, evaluate_source(expression, scope));
}

Value TextEvaluator::evaluate_source(const std::string& source, Scope& scope) {
  auto& expression = expressions_[source];
  if (!expression) expression = expression::parse_expression(source);
  const auto held = expression;  // evaluation may add others
  return expression::evaluate(runtime_, *held, scope);
}

std::optional<Value> TextEvaluator::look_up(Scope& scope, const std::string& name) {
  const auto found = scope.find(name);
  if (!found) return std::nullopt;
  return property_value(found, name);
}

Value TextEvaluator::property_value(const Scope::Found& found, const std::string& name) {
  Property& property = *found.property;
  if (!property.is_unevaluated) return property.value;
  auto& open = found.scope->evaluating;
  if (std::find(open.begin(), open.end(), name) != open.end()) {
    fail_eval(
        fmt::format("circular variable definition: {} -> {} Consider disabling lazy evaluation via lazy_eval=\"false\"",
                    fmt::join(open, " -> "), name));
  }
  open.push_back(name);
  const Value::Text text = *property.value.as<Value::Text>();  // keeps it: evaluation may replace the property
  Value value = expression::literal_of(value_of(*text, property.at, *found.scope));
  open.pop_back();
  property.value = value;
  property.is_unevaluated = false;
  return value;
}

bool condition_of(const Value& value, const std::string& condition, const Position& at) {
  if (const auto boolean = expression::boolean_literal(value)) return *boolean;
  throw Failure{code::xacro_condition,
                fmt::format("Xacro conditional \"{}\" evaluated to \"{}\", which is not a boolean expression.",
                            condition, *value.text()),
                at,
                {},
                {"valid here: true, false, a whole number, or a comparison such as ${name == 'left'}"}};
}

}  // namespace finemote::gen::xacro
