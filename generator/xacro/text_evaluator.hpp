// Texts with ${} and $() to values.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>

#include "generator/xacro/arguments.hpp"
#include "generator/xacro/current_piece.hpp"
#include "generator/xacro/engine.hpp"
#include "generator/xacro/text.hpp"
#include "generator/xacro/world.hpp"

namespace finemote::gen::xacro {

/// Cuts and parses each text once, and evaluates it as often as it is asked. A property whose text is still to be
/// evaluated gets its value when an expression first names it.
class TextEvaluator : private expression::Names {
 public:
  /// @param piece  tells `world` where the functions are called that ask it
  TextEvaluator(World& world, ArgumentTable& arguments, CurrentPiece& piece, Scope& builtins)
      : world_(world), arguments_(arguments), current_(piece), runtime_(*this, world, builtins) {}

  /// The text with its pieces evaluated. Fails at the piece to blame.
  /// @param at  where the text begins
  std::string text_of(const std::string& text, const Position& at, Scope& scope);
  /// The same, but a text that is one expression has the expression's value.
  Value value_of(const std::string& text, const Position& at, Scope& scope);

  /// The value of a property, evaluated now if it was not.
  Value property_value(const Scope::Found& found, const std::string& name);

  /// Work that expressions share with all other work of an expansion.
  [[nodiscard]] Budget& budget() { return runtime_.budget; }

 private:
  /// A text that is being evaluated: its words, where they begin, and the names they see.
  struct Subject {
    const std::string& words;
    const Position& at;
    Scope& scope;

    [[nodiscard]] Position place(const Piece& piece) const { return place_inside(at, words, piece.offset); }
  };

  std::optional<Value> look_up(Scope& scope, const std::string& name) override;

  const Text& cut_of(const std::string& text);
  Value evaluate(const Text& text, const Subject& subject);
  std::string joined(const Text& text, const Subject& subject);
  std::string pieces_of(const Text& text, const Subject& subject);
  static void check_piece(const Text& text, std::size_t i, const Subject& subject);
  Value evaluate_piece(const Piece& piece, const Subject& subject);
  std::string inner_of(const Piece& piece, const Subject& subject);
  Value evaluate_expression(const Piece& piece, const Subject& subject);
  std::string evaluate_substitution(const std::string& inside);
  std::string evaluate_with_arguments(const std::string& expression);
  Value evaluate_source(const std::string& source, Scope& scope);

  World& world_;
  ArgumentTable& arguments_;
  CurrentPiece& current_;
  Runtime runtime_;
  std::unordered_map<std::string, std::unique_ptr<const Text>> texts_;
  std::unordered_map<std::string, std::shared_ptr<const Expression>> expressions_;
  std::size_t depth_ = 0;  // of pieces inside pieces, through properties
};

/// True or false; fails at `at` when the value is neither.
/// @param condition  the text it comes from, for the message
bool condition_of(const Value& value, const std::string& condition, const Position& at);

}  // namespace finemote::gen::xacro
