// The XML tree every reader of the tool works on: plain values that know where they were written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/diagnostic/source.hpp"

namespace finemote::gen::xml {

struct Attribute {
  std::string name;  ///< as written, with prefix
  std::string value;
  Position at;        ///< first byte of the name
  Position value_at;  ///< first byte of the value, after the quote
};

struct Node {
  enum class Kind { element, text, cdata, comment, instruction };
  Kind kind = Kind::element;
  std::string name;  ///< element name or instruction target, with prefix; else empty
  std::string text;  ///< content of text, cdata, comment, instruction; else empty
  Position at;       ///< first byte of the construct ('<' of a tag)
  std::vector<Attribute> attributes;
  std::vector<Node> children;

  [[nodiscard]] bool is_element() const { return kind == Kind::element; }
  [[nodiscard]] bool is_element(std::string_view tag) const { return is_element() && name == tag; }
  [[nodiscard]] const Attribute* attribute(std::string_view attribute_name) const {
    for (const Attribute& a : attributes) {
      if (a.name == attribute_name) return &a;
    }
    return nullptr;
  }
};

/// A whole document: the nodes around the root (comments, instructions) and the root.
struct Document {
  std::vector<Node> prolog;  ///< before the root element
  Node root;
  std::vector<Node> epilog;  ///< after it
};

}  // namespace finemote::gen::xml
