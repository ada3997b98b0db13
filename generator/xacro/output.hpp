// The document an expansion builds: its elements are numbered, its size and depth have limits.
#pragma once

#include <cstddef>
#include <cstdint>

#include "generator/xacro/comments.hpp"
#include "generator/xacro/engine.hpp"
#include "generator/xml/node.hpp"

namespace finemote::gen::xacro {

class Output {
 public:
  /// A new element to fill.
  [[nodiscard]] Sink open(xml::Node& element) { return {element, ++elements_}; }
  /// Fails when elements are nested too deeply.
  [[nodiscard]] Level enter_element(const Position& at);

  /// Puts a complete node after the others; fails when the document becomes too large, or could not be XML.
  void add(xml::Node node, const Sink& to);
  /// Puts an attribute to the others of an element that is not in place yet.
  void add(xml::Attribute attribute, xml::Node& element);

 private:
  std::uint64_t elements_ = 0;  // opened so far
  std::size_t size_ = 0;        // bytes
  std::size_t depth_ = 0;
};

/// Sets an attribute, in the place of an old one of that name; fails for a value that no XML document may hold.
void set_attribute(xml::Node& element, xml::Attribute attribute);

}  // namespace finemote::gen::xacro
