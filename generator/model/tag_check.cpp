#include "generator/model/tag_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/diagnostic/suggest.hpp"
#include "generator/model/attributes.hpp"

namespace finemote::gen {

using grammar::AttributeRule;
using grammar::ElementRule;

namespace {

/// Elements whose names must differ; that of a <param> or a <board> is another's.
bool has_own_name(const xml::Node& node) {
  return node.is_element("bus") || node.is_element("expander") || node.is_element("channel") ||
         node.is_element("device");
}

}  // namespace

void TagCheck::check(const xml::Node& node, const xml::Node* around) {
  const ElementRule& rule = *grammar::rule(node.name);
  around_ = around;
  check_attributes(node, rule);
  for (const xml::Node& child : node.children) check_child(node, child, rule);
}

void TagCheck::check_attributes(const xml::Node& node, const ElementRule& rule) {
  std::vector<std::string> names;
  for (const AttributeRule& known : rule.attributes) names.emplace_back(known.name);
  for (const xml::Attribute& attribute : node.attributes) {
    if (attribute.name == "xmlns" || attribute.name.starts_with("xmlns:")) continue;
    if (std::find(names.begin(), names.end(), attribute.name) != names.end()) continue;
    for (std::string& near : nearest_names(attribute.name, names)) tags_.misspelt.emplace(&node, std::move(near));
    report_unknown_attribute(node, attribute, names);
  }
  for (const AttributeRule& known : rule.attributes) {
    const bool is_missing = known.required && node.attribute(known.name) == nullptr;
    if (is_missing && !tags_.is_misspelt(node, known.name)) report_missing_attribute(node, known);
  }
}

void TagCheck::report_unknown_attribute(const xml::Node& node, const xml::Attribute& attribute,
                                        const std::vector<std::string>& names) {
  auto& finding = diagnostics_.error(code::unknown_attribute, attribute.at,
                                     fmt::format("<{}> has no attribute '{}'", node.name, attribute.name));
  finding.underline(attribute.name.size());
  if (attribute.name.starts_with("xacro:") && !from_xacro_) {
    finding.code = code::xacro_in_urdf;
    tags_.has_xacro = true;
    finding.message = fmt::format("'{}' in a file that is read as plain URDF", attribute.name);
    finding.hint("rename the file to end in .urdf.xacro, or expand it first with 'finemote xacro'");
  } else if (node.is_element("device") && attribute.name == "class") {
    finding.hint("a device says type=\"...\"; the class is named in the type's descriptor");
  } else {
    const std::string hint = did_you_mean(attribute.name, names);
    if (!hint.empty()) finding.hint(hint);
  }
}

void TagCheck::report_missing_attribute(const xml::Node& node, const AttributeRule& known) {
  const xml::Attribute* name = node.attribute("name");
  const std::string which = name != nullptr && known.name != "name" ? fmt::format("{} '{}'", node.name, name->value)
                                                                    : fmt::format("<{}>", node.name);
  at_tag(diagnostics_, code::attribute_missing, node, fmt::format("{} has no '{}'", which, known.name))
      .hint(fmt::format("add for example {}=\"{}\"", known.name, example(node, known)));
}

std::string TagCheck::example(const xml::Node& node, const AttributeRule& known) {
  if (node.is_element("board") && known.name == "name") return suggested_.board();
  if (node.is_element("expander") && known.name == "model") return suggested_.mux();
  if (has_own_name(node) && known.name == "name") return free_name(std::string(known.example));
  if (!node.is_element("channel") || known.name != "index") return std::string(known.example);
  for (std::uint32_t index = 0;; ++index) {
    if (indices_[around_].insert(std::to_string(index)).second) return std::to_string(index);
  }
}

std::string TagCheck::free_name(std::string name) {
  const std::string stem = name.substr(0, name.find("_0"));
  for (std::uint32_t number = stem == name ? 2 : 1; !names_.insert(name).second; ++number)
    name = fmt::format("{}_{}", stem, number);
  return name;
}

void TagCheck::collect_names(const xml::Node& node) {
  for (const xml::Node& child : node.children) {
    if (!child.is_element()) continue;
    if (has_own_name(child)) names_.insert(std::string(value_of(child, "name")));
    if (child.is_element("channel")) indices_[&node].insert(std::string(value_of(child, "index")));
    collect_names(child);
  }
}

void TagCheck::check_child(const xml::Node& node, const xml::Node& child, const ElementRule& rule) {
  const bool is_text = child.kind == xml::Node::Kind::text || child.kind == xml::Node::Kind::cdata;
  if (is_text && !rule.has_text && !trim(child.text).empty()) report_text(node, child);
  if (!child.is_element() || rule.allows_child(child.name)) return;
  if (child.name.starts_with("xacro:")) return;  // said by find_xacro
  auto& finding = at_tag(diagnostics_, code::unknown_element, child,
                         fmt::format("<{}> is not allowed in <{}>", child.name, node.name));
  if (child.name == "import") {
    finding.hint("this version cannot import <ros2_control>; write the devices as <device> elements");
  } else if (child.name == "mux") {
    finding.hint(fmt::format("write <expander name=\"...\" model=\"{}\" bus=\"...\" address=\"0x70\"> beside the <bus>",
                             suggested_.mux()));
  } else if (!rule.children.empty()) {
    finding.hint(did_you_mean(child.name, {rule.children.begin(), rule.children.end()}));
  }
}

void TagCheck::report_text(const xml::Node& node, const xml::Node& text) {
  const TextAt inner = trimmed_text(text);
  diagnostics_.error(code::unexpected_text, inner.at, fmt::format("text in <{}>", node.name))
      .underline(inner.text.size())
      .hint("remove it, or make it a comment: <!-- ... -->");
}

}  // namespace finemote::gen
