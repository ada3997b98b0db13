// The elements of the extension, version 1: what each may hold. One table for the reader, the lists in messages and the
// test that holds the XSD against it.
#pragma once

#include <span>
#include <string_view>

namespace finemote::gen::grammar {

struct AttributeRule {
  std::string_view name;
  bool required = false;
  std::string_view example = "...";  ///< for hints that can be pasted
};

struct ElementRule {
  std::string_view name;
  std::span<const AttributeRule> attributes;
  std::span<const std::string_view> children;
  bool has_text = false;

  [[nodiscard]] bool allows_child(std::string_view child) const;
};

/// Rule of an element; the names stand once each, except that `param` and others mean the same everywhere.
const ElementRule* rule(std::string_view element);

/// All of them.
std::span<const ElementRule> rules();

}  // namespace finemote::gen::grammar
