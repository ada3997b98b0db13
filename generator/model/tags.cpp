#include "generator/model/tags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "generator/diagnostic/suggest.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/grammar.hpp"
#include "generator/model/names.hpp"

namespace finemote::gen {
namespace {

using grammar::AttributeRule;
using grammar::ElementRule;

bool starts_with(std::string_view text, std::string_view prefix) { return text.substr(0, prefix.size()) == prefix; }

class TagReader {
 public:
  TagReader(bool from_xacro, const std::vector<std::string>& expander_models, Diagnostics& diagnostics)
      : from_xacro_(from_xacro), expander_models_(expander_models), diagnostics_(diagnostics) {}

  Tags read(const xml::Node& robot) {
    find_xacro(robot);
    for (const xml::Node& child : robot.children) {
      if (child.is_element("finemote")) collect_names(child);
    }
    for (const xml::Node& child : robot.children) {
      if (child.is_element("finemote"))
        read_block(child);
      else if (child.is_element())
        check_foreign(child);
    }
    return std::move(tags_);
  }

 private:
  void check_foreign(const xml::Node& child) {
    if (report_outside_block(child)) return;
    find_misspelt_block(child);
    find_unread_blocks(child);
  }
  /// `<device>` and the like directly below `<robot>`, where no other extension has them. A `<param>` may be anyone's.
  bool report_outside_block(const xml::Node& node) {
    const ElementRule* known = grammar::rule(node.name);
    if (known == nullptr || node.is_element("param")) return false;
    const bool is_in_block = allows_child(*grammar::rule("finemote"), node.name);
    at_tag(diagnostics_, code::unknown_element, node, fmt::format("<{}> outside <finemote>", node.name))
        .note("it would not be read here")
        .hint(is_in_block ? "move it into <finemote version=\"1\">" : "move it into its element inside <finemote>");
    return true;
  }
  /// A <finemote> anywhere below an element that is not ours.
  void find_unread_blocks(const xml::Node& node) {
    for (const xml::Node& child : node.children) {
      if (child.is_element("finemote")) {
        at_tag(diagnostics_, code::unknown_element, child, fmt::format("<finemote> inside <{}>", node.name))
            .note("it would not be read here")
            .hint("move it out: <finemote> stands directly inside <robot>");
      } else if (child.is_element()) {
        find_unread_blocks(child);
      }
    }
  }
  /// `Finemote`, `fine_mote`: ROS tools ignore such an element silently, so nobody else would say it.
  void find_misspelt_block(const xml::Node& node) {
    if (!is_mistyped(node.name, "finemote")) return;
    at_tag(diagnostics_, code::unknown_element, node, fmt::format("unknown element <{}>", node.name))
        .hint("did you mean <finemote>?");
  }

  /// One message for the first xacro tag: the rest follows from it.
  bool find_xacro(const xml::Node& node) {
    if (starts_with(node.name, "xacro:")) {
      if (node.name != "xacro:deprecated") report_xacro(node);
      return true;
    }
    return std::any_of(node.children.begin(), node.children.end(),
                       [&](const xml::Node& child) { return child.is_element() && find_xacro(child); });
  }
  void report_xacro(const xml::Node& node) {
    tags_.has_xacro = true;
    auto& finding = at_tag(diagnostics_, code::xacro_in_urdf, node,
                           fmt::format("<{}> in a file that is read as plain URDF", node.name));
    if (from_xacro_) {
      finding.message = fmt::format("xacro did not know <{}>", node.name);
    } else {
      finding.hint("rename the file to end in .urdf.xacro, or expand it first with 'finemote xacro'");
    }
  }

  void read_block(const xml::Node& block) {
    tags_.blocks.push_back(&block);
    check(block);
    for (const xml::Node& child : block.children) {
      if (child.is_element("board")) take(child, tags_.boards);
      if (child.is_element("bus") && !is_misnamed_expander(child)) take(child, tags_.buses);
      if (child.is_element("expander")) take(child, tags_.expanders);
      if (child.is_element("require")) take(child, tags_.requirements);
      if (child.is_element("device")) take_device(child, {});
    }
  }
  /// `<bus type="tca9548a">`: said once, by the reader of expanders; what else is odd about it follows from that.
  bool is_misnamed_expander(const xml::Node& node) {
    const std::string type = fold_case(value_of(node, "type"));
    if (std::find(expander_models_.begin(), expander_models_.end(), type) == expander_models_.end()) return false;
    tags_.misnamed_expanders.push_back(&node);
    tags_.lost_buses.emplace_back(value_of(node, "name"));
    for (const xml::Node& child : node.children) {
      if (child.is_element()) tags_.lost_buses.emplace_back(value_of(child, "name"));
    }
    return true;
  }
  template <class List>
  void take(const xml::Node& node, List& list) {
    list.push_back(&node);
    check(node);
    around_ = &node;
    for (const xml::Node& child : node.children) {
      if (child.is_element() && grammar::rule(child.name) != nullptr) check(child);
    }
  }
  void take_device(const xml::Node& node, std::optional<DeviceId> nested_in) {
    const DeviceId device = tags_.devices.push_back({&node, nested_in});
    check(node);
    for (const xml::Node& child : node.children) {
      if (child.is_element("device"))
        take_device(child, device);
      else if (child.is_element() && allows_child(*grammar::rule("device"), child.name))
        check(child);
    }
  }

  static bool allows_child(const ElementRule& rule, std::string_view name) {
    return std::find(rule.children.begin(), rule.children.end(), name) != rule.children.end();
  }

  void check(const xml::Node& node) {
    const ElementRule& rule = *grammar::rule(node.name);
    check_attributes(node, rule);
    for (const xml::Node& child : node.children) check_child(node, child, rule);
  }
  void check_attributes(const xml::Node& node, const ElementRule& rule) {
    std::vector<std::string> names;
    for (const AttributeRule& known : rule.attributes) names.emplace_back(known.name);
    for (const xml::Attribute& attribute : node.attributes) {
      if (attribute.name == "xmlns" || starts_with(attribute.name, "xmlns:")) continue;
      if (std::find(names.begin(), names.end(), attribute.name) != names.end()) continue;
      for (std::string& near : nearest_names(attribute.name, names)) tags_.misspelt.emplace(&node, std::move(near));
      report_unknown_attribute(node, attribute, names);
    }
    for (const AttributeRule& known : rule.attributes) {
      const bool is_missing = known.required && node.attribute(known.name) == nullptr;
      if (is_missing && !tags_.is_misspelt(node, known.name)) report_missing_attribute(node, known);
    }
  }
  void report_unknown_attribute(const xml::Node& node, const xml::Attribute& attribute,
                                const std::vector<std::string>& names) {
    auto& finding = diagnostics_.error(code::unknown_attribute, attribute.at,
                                       fmt::format("<{}> has no attribute '{}'", node.name, attribute.name));
    finding.underline(attribute.name.size());
    if (starts_with(attribute.name, "xacro:") && !from_xacro_) {
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
  void report_missing_attribute(const xml::Node& node, const AttributeRule& known) {
    const xml::Attribute* name = node.attribute("name");
    const std::string which = name != nullptr && known.name != "name" ? fmt::format("{} '{}'", node.name, name->value)
                                                                      : fmt::format("<{}>", node.name);
    at_tag(diagnostics_, code::attribute_missing, node, fmt::format("{} has no '{}'", which, known.name))
        .hint(fmt::format("add for example {}=\"{}\"", known.name, example(node, known)));
  }
  /// What no other element has yet, and no other finding offers.
  std::string example(const xml::Node& node, const AttributeRule& known) {
    if (has_own_name(node) && known.name == "name") return free_name(std::string(known.example));
    if (!node.is_element("channel") || known.name != "index") return std::string(known.example);
    for (std::uint32_t index = 0;; ++index) {
      if (indices_[around_].insert(std::to_string(index)).second) return std::to_string(index);
    }
  }
  std::string free_name(std::string name) {
    const std::string stem = name.substr(0, name.find("_0"));
    for (std::uint32_t number = stem == name ? 2 : 1; !names_.insert(name).second; ++number)
      name = fmt::format("{}_{}", stem, number);
    return name;
  }
  /// Elements whose names must differ; that of a <param> or a <board> is another's.
  static bool has_own_name(const xml::Node& node) {
    return node.is_element("bus") || node.is_element("expander") || node.is_element("channel") ||
           node.is_element("device");
  }
  void collect_names(const xml::Node& node) {
    for (const xml::Node& child : node.children) {
      if (!child.is_element()) continue;
      if (has_own_name(child)) names_.insert(std::string(value_of(child, "name")));
      if (child.is_element("channel")) indices_[&node].insert(std::string(value_of(child, "index")));
      collect_names(child);
    }
  }

  void check_child(const xml::Node& node, const xml::Node& child, const ElementRule& rule) {
    const bool is_text = child.kind == xml::Node::Kind::text || child.kind == xml::Node::Kind::cdata;
    if (is_text && !rule.has_text && !trim(child.text).empty()) report_text(node, child);
    if (!child.is_element() || allows_child(rule, child.name)) return;
    if (starts_with(child.name, "xacro:")) return;  // said by find_xacro
    auto& finding = at_tag(diagnostics_, code::unknown_element, child,
                           fmt::format("<{}> is not allowed in <{}>", child.name, node.name));
    if (child.name == "import") {
      finding.hint("this version cannot import <ros2_control>; write the devices as <device> elements");
    } else if (child.name == "mux") {
      finding.hint("write <expander name=\"...\" model=\"tca9548a\" bus=\"...\" address=\"0x70\"> beside the <bus>");
    } else if (!rule.children.empty()) {
      finding.hint(did_you_mean(child.name, {rule.children.begin(), rule.children.end()}));
    }
  }
  void report_text(const xml::Node& node, const xml::Node& text) {
    const TextAt inner = trimmed_text(text);
    diagnostics_.error(code::unexpected_text, inner.at, fmt::format("text in <{}>", node.name))
        .underline(inner.text.size())
        .hint("remove it, or make it a comment: <!-- ... -->");
  }

  bool from_xacro_;
  const std::vector<std::string>& expander_models_;
  Diagnostics& diagnostics_;
  Tags tags_;
  std::set<std::string> names_;                                ///< there, or offered
  std::map<const xml::Node*, std::set<std::string>> indices_;  ///< of the channels of an expander, likewise
  const xml::Node* around_ = nullptr;                          ///< the element whose children are checked
};

}  // namespace

Tags read_tags(const xml::Node& robot, bool from_xacro, const std::vector<std::string>& expander_models,
               Diagnostics& diagnostics) {
  return TagReader(from_xacro, expander_models, diagnostics).read(robot);
}

}  // namespace finemote::gen
