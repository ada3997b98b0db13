// A text of an XML file cut into what is copied and what is evaluated: ${expression}, $(substitution), plain.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "generator/xacro/engine.hpp"

namespace finemote::gen::xacro {

struct Text;

struct Piece {
  enum class Kind { plain, expression, substitution, malformed };
  Kind kind = Kind::plain;
  std::string text;        ///< what to copy, or what is between the brackets; from here to the end when malformed
  std::size_t offset = 0;  ///< of the piece in the whole text, in bytes
  mutable std::shared_ptr<const Expression> compiled;  ///< of an expression without inner text, made at first use
  std::unique_ptr<const Text> inner;  ///< the cut text between the brackets when it holds a '$' itself; else null
};

struct Text {
  std::vector<Piece> pieces;
};

/// Cuts a text. `$${` and `$$(` lose one dollar and are copied; a dollar before another character is copied.
Text cut_text(std::string_view text);

}  // namespace finemote::gen::xacro
