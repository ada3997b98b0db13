// What surrounds a piece of source: the names it sees and the way it was reached.
#pragma once

#include "generator/xacro/engine.hpp"
#include "generator/xacro/macro.hpp"

namespace finemote::gen::xacro {

struct Context {
  Scope* scope = nullptr;
  MacroScope* macros = nullptr;
  const Expansion* via = nullptr;
  bool is_placed = false;  ///< the nodes carry their way already: a block that was evaluated by its caller

  /// A place in the source, with the way it was reached.
  [[nodiscard]] Position place(Position at) const {
    if (!is_placed) at.via = via;
    return at;
  }
};

}  // namespace finemote::gen::xacro
