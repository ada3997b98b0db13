#include "generator/xacro/output.hpp"

#include <fmt/format.h>

#include "generator/xacro/limits.hpp"
#include "generator/xml/characters.hpp"
#include "generator/xml/write.hpp"

namespace finemote::gen::xacro {
namespace {

constexpr std::size_t kNodeCost = 192;  // bytes of bookkeeping that a node counts for at least

void insist_on_characters(std::string_view text, const Position& at) {
  if (!xml::are_characters(text))
    throw Failure{code::xacro_no_xml, "the text has a control character, which XML cannot hold", at};
}

}  // namespace

Level Output::enter_element(const Position& at) {
  return enter(depth_, kMaxOutputDepth, "elements are nested too deeply", at);
}

void Output::add(xml::Node node, const Sink& to) {
  insist_on_characters(node.text, node.at);
  const std::size_t indents = 2 * xml::kIndentStep.size() * depth_;  // of its first line and its last
  size_ += node.name.size() + node.text.size() + indents + kNodeCost;
  if (size_ > kMaxOutput) {
    throw Failure{code::xacro_limit, fmt::format("the output is larger than {} MiB", kMaxOutput >> 20), node.at};
  }
  to.element.children.push_back(std::move(node));
}

void Output::add(xml::Attribute attribute, xml::Node& element) {
  insist_on_characters(attribute.value, attribute.value_at);
  size_ += attribute.name.size() + attribute.value.size() + kNodeCost;
  element.attributes.push_back(std::move(attribute));
}

void set_attribute(xml::Node& element, xml::Attribute attribute) {
  insist_on_characters(attribute.value, attribute.value_at);
  for (xml::Attribute& a : element.attributes) {
    if (a.name != attribute.name) continue;
    a = std::move(attribute);
    return;
  }
  element.attributes.push_back(std::move(attribute));
}

}  // namespace finemote::gen::xacro
