#include "generator/model/tags.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/diagnostic/suggest.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/grammar.hpp"
#include "generator/model/names.hpp"
#include "generator/model/tag_check.hpp"

namespace finemote::gen {
namespace {

using grammar::ElementRule;

class TagReader {
 public:
  TagReader(bool from_xacro, const std::vector<std::string>& expander_models, const Suggested& suggested,
            Diagnostics& diagnostics)
      : from_xacro_(from_xacro), expander_models_(expander_models), suggested_(suggested), diagnostics_(diagnostics) {}

  Tags read(const xml::Node& robot) {
    find_xacro(robot);
    for (const xml::Node& child : robot.children) {
      if (child.is_element("finemote")) check_.collect_names(child);
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
    const bool is_in_block = grammar::rule("finemote")->allows_child(node.name);
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
    if (node.name.starts_with("xacro:")) {
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
    check_.check(block);
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
    check_.check(node);
    for (const xml::Node& child : node.children) {
      if (child.is_element() && grammar::rule(child.name) != nullptr) check_.check(child, &node);
    }
  }
  void take_device(const xml::Node& node, std::optional<DeviceId> nested_in) {
    const DeviceId device = tags_.devices.push_back({&node, nested_in});
    check_.check(node);
    for (const xml::Node& child : node.children) {
      if (child.is_element("device"))
        take_device(child, device);
      else if (child.is_element() && grammar::rule("device")->allows_child(child.name))
        check_.check(child);
    }
  }

  bool from_xacro_;
  const std::vector<std::string>& expander_models_;
  const Suggested& suggested_;
  Diagnostics& diagnostics_;
  Tags tags_;
  TagCheck check_{from_xacro_, suggested_, tags_, diagnostics_};
};

}  // namespace

Tags read_tags(const xml::Node& robot, bool from_xacro, const std::vector<std::string>& expander_models,
               const Suggested& suggested, Diagnostics& diagnostics) {
  return TagReader(from_xacro, expander_models, suggested, diagnostics).read(robot);
}

}  // namespace finemote::gen
