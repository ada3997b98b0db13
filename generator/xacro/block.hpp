// An element kept for insert_block; evaluated again at each insertion.
#pragma once

#include <memory>
#include <utility>

#include "generator/xacro/engine.hpp"
#include "generator/xml/node.hpp"

namespace finemote::gen::xacro {

struct Block : expression::Opaque {
  Block(std::shared_ptr<const xml::Node> kept, const Expansion* reached, bool placed)
      : node(std::move(kept)), via(reached), is_placed(placed) {}

  std::shared_ptr<const xml::Node> node;
  const Expansion* via;  ///< how its text was reached
  bool is_placed;        ///< evaluated before: its nodes carry their way already
};

/// The value a scope holds for a block.
inline Value block_value(std::shared_ptr<const xml::Node> node, const Expansion* via, bool is_placed) {
  return Value(
      std::shared_ptr<const expression::Opaque>(std::make_shared<const Block>(std::move(node), via, is_placed)));
}

/// The block that a value is, or null.
inline std::shared_ptr<const Block> block_of(const Value& value) {
  const auto* held = value.as<std::shared_ptr<const expression::Opaque>>();
  return held != nullptr ? std::dynamic_pointer_cast<const Block>(*held) : nullptr;
}

}  // namespace finemote::gen::xacro
