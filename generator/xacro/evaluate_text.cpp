// Texts with ${} and $() to values.
#include <fmt/format.h>

#include <algorithm>
#include <new>

#include "generator/xacro/expander.hpp"

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

}  // namespace

std::string Expander::text_of(const std::string& text, const Position& at, Scope& scope) {
  if (text.find('$') == std::string::npos) return text;
  const Text& cut = cut_of(text);
  if (evaluation_depth_ == 0) runtime_.budget.begin_expression();
  return text_of_pieces(cut, at, text, scope);
}

Value Expander::value_of(const std::string& text, const Position& at, Scope& scope) {
  if (text.find('$') == std::string::npos) return text;
  const Text& cut = cut_of(text);
  if (evaluation_depth_ == 0) runtime_.budget.begin_expression();
  return evaluate_pieces(cut, at, text, scope);
}

/// The text cut once for all its uses.
const Text& Expander::cut_of(const std::string& text) {
  auto& cut = texts_[text];
  if (!cut) cut = std::make_unique<const Text>(cut_text(text));
  return *cut;
}

/// A text that is one expression has the expression's value; all others are text.
Value Expander::evaluate_pieces(const Text& text, const Position& at, const std::string& whole, Scope& scope) {
  if (text.pieces.size() != 1) return text_of_pieces(text, at, whole, scope);
  check_piece(text, 0, at, whole);
  return evaluate_piece(text.pieces[0], at, whole, scope);
}

std::string Expander::text_of_pieces(const Text& text, const Position& at, const std::string& whole, Scope& scope) {
  if (text.pieces.size() == 1) return to_text(runtime_, evaluate_pieces(text, at, whole, scope));
  check_piece(text, 0, at, whole);
  std::string joined;
  for (std::size_t i = 0; i < text.pieces.size(); ++i) {
    check_piece(text, i + 1, at, whole);  // before this piece is evaluated, as ROS xacro reads one piece ahead
    const Piece& piece = text.pieces[i];
    joined +=
        piece.kind == Piece::Kind::plain ? piece.text : to_text(runtime_, evaluate_piece(piece, at, whole, scope));
    if (joined.size() > expression::kMaxText) fail_limit("the text is too long");
  }
  runtime_.budget.spend(joined.size() / 16);
  return joined;
}

/// Fails if piece `i` is an opening bracket without its closing one.
void Expander::check_piece(const Text& text, std::size_t i, const Position& at, const std::string& whole) {
  if (i >= text.pieces.size() || text.pieces[i].kind != Piece::Kind::malformed) return;
  const Piece& piece = text.pieces[i];
  std::vector<std::string> hints;
  if (piece.text.starts_with("${")) hints.push_back("close it with '}'; for the text itself write '$${'");
  if (piece.text.starts_with("$(")) hints.push_back("close it with ')'; for the text itself write '$$('");
  throw Failure{code::xacro_text,
                "invalid expression: " + excerpt(piece.text),
                inside(at, whole, piece.offset),
                {},
                std::move(hints)};
}

/// Tells the built-ins where they are called, for as long as one piece is evaluated.
class Expander::CurrentPiece {
 public:
  CurrentPiece(Expander& expander, const Position& at, const std::string& whole, std::size_t offset)
      : expander_(expander), at_(expander.current_), text_(expander.current_text_), offset_(expander.current_offset_) {
    expander_.current_ = at;
    expander_.current_text_ = &whole;
    expander_.current_offset_ = offset;
  }
  ~CurrentPiece() {
    expander_.current_ = at_;
    expander_.current_text_ = text_;
    expander_.current_offset_ = offset_;
  }
  CurrentPiece(const CurrentPiece&) = delete;
  CurrentPiece& operator=(const CurrentPiece&) = delete;

 private:
  Expander& expander_;
  Position at_;
  const std::string* text_;
  std::size_t offset_;
};

Value Expander::evaluate_piece(const Piece& piece, const Position& at, const std::string& whole, Scope& scope) {
  if (piece.kind == Piece::Kind::plain) return piece.text;
  const Level level(evaluation_depth_, kMaxNestedCalls, "maximum recursion depth exceeded in expressions");
  const CurrentPiece current(*this, at, whole, piece.offset);
  const bool is_expression = piece.kind == Piece::Kind::expression;
  try {
    return is_expression ? evaluate_expression(piece, at, whole, scope)
                         : Value(substitute(*this, inner_of(piece, at, whole, scope)));
  } catch (Failure& failure) {
    if (is_expression) failure.message += fmt::format(" when evaluating expression '{}'", excerpt(piece.text));
    const bool is_elsewhere = failure.at.file != nullptr && (failure.at.file != at.file || failure.at.line != at.line);
    constexpr std::size_t most_notes = 8;
    if (failure.at.file == nullptr) {
      failure.at = inside(at, whole, piece.offset);
    } else if (is_elsewhere && failure.notes.size() < most_notes) {
      failure.notes.push_back({fmt::format("needed for '{}'", excerpt(piece.text)), inside(at, whole, piece.offset)});
    }
    throw;
  } catch (const std::bad_alloc&) {
    throw Failure{code::xacro_limit, "the expression needs more memory than there is", inside(at, whole, piece.offset)};
  }
}

std::string Expander::inner_of(const Piece& piece, const Position& at, const std::string& whole, Scope& scope) {
  return piece.inner ? text_of_pieces(*piece.inner, at, whole, scope) : piece.text;
}

Value Expander::evaluate_expression(const Piece& piece, const Position& at, const std::string& whole, Scope& scope) {
  if (piece.inner) return evaluate_source(inner_of(piece, at, whole, scope), scope);
  if (!piece.compiled) piece.compiled = expression::parse_expression(piece.text);
  return expression::evaluate(runtime_, *piece.compiled, scope);
}

Value Expander::evaluate_source(const std::string& source, Scope& scope) {
  auto& expression = expressions_[source];
  if (!expression) expression = expression::parse_expression(source);
  const auto held = expression;  // evaluation may add others
  return expression::evaluate(runtime_, *held, scope);
}

Value Expander::property_value(const Scope::Found& found, const std::string& name) {
  expression::Property& property = *found.property;
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

bool Expander::boolean_of(const Value& value, const std::string& condition, const Position& at) {
  if (const auto boolean = expression::boolean_literal(value)) return *boolean;
  throw Failure{code::xacro_condition,
                fmt::format("Xacro conditional \"{}\" evaluated to \"{}\", which is not a boolean expression.",
                            condition, *value.text()),
                at,
                {},
                {"valid here: true, false, a whole number, or a comparison such as ${name == 'left'}"}};
}

/// The place `offset` bytes into a text that begins at `at`; its beginning where entities or line breaks in attributes
/// make the source differ from the text.
Position Expander::inside(Position at, const std::string& whole, std::size_t offset) {
  if (at.file == nullptr || at.line == 0 || at.column == 0) return at;
  std::string_view line = at.file->line(at.line);
  if (at.column > line.size() + 1) return at;
  line.remove_prefix(at.column - 1);
  Position moved = at;
  for (std::size_t i = 0; i < offset; ++i) {
    if (whole[i] == '\n' && line.empty()) {
      line = at.file->line(++moved.line);
      moved.column = 1;
    } else if (!line.empty() && line[0] == whole[i]) {
      line.remove_prefix(1);
      ++moved.column;
    } else {
      return at;
    }
  }
  return moved;
}

}  // namespace finemote::gen::xacro
