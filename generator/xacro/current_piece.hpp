// Where the `${` or `$(` that is being evaluated stands.
#pragma once

#include <cstddef>
#include <string>

#include "generator/diagnostic/source.hpp"

namespace finemote::gen::xacro {

/// The place `offset` bytes into a text that begins at `at`; its beginning where entities or line breaks in attributes
/// make the source differ from the text.
Position place_inside(Position at, const std::string& text, std::size_t offset);

/// A piece of a text that is evaluated. The evaluation of texts sets it; the functions that expressions call read it.
struct CurrentPiece {
  Position at;                        ///< of the text
  const std::string* text = nullptr;  ///< null when nothing is evaluated
  std::size_t offset = 0;             ///< of the piece in the text, in bytes

  [[nodiscard]] Position position() const { return text == nullptr ? at : place_inside(at, *text, offset); }
};

}  // namespace finemote::gen::xacro
