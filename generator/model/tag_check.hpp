// One tag beside the grammar of the extension: attributes, children and text that belong there or do not.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/model/grammar.hpp"
#include "generator/model/tags.hpp"

namespace finemote::gen {

/// Checks tags one by one. Reports FM3008, FM3009, FM3010, FM3028 and FM1002 as read_tags() says, and notes in `tags`
/// what was misspelt. What it offers as an example nothing else has, and no other finding offers.
class TagCheck {
 public:
  TagCheck(bool from_xacro, const Suggested& suggested, Tags& tags, Diagnostics& diagnostics)
      : from_xacro_(from_xacro), suggested_(suggested), tags_(tags), diagnostics_(diagnostics) {}

  /// Notes the names there are, which are not offered: before the first check().
  void collect_names(const xml::Node& node);
  /// A tag that the grammar knows, without what its children say of themselves. `around`: the expander of a channel.
  void check(const xml::Node& node, const xml::Node* around = nullptr);

 private:
  void check_attributes(const xml::Node& node, const grammar::ElementRule& rule);
  void report_unknown_attribute(const xml::Node& node, const xml::Attribute& attribute,
                                const std::vector<std::string>& names);
  void report_missing_attribute(const xml::Node& node, const grammar::AttributeRule& known);
  /// Of an attribute that is missing.
  std::string example(const xml::Node& node, const grammar::AttributeRule& known);
  std::string free_name(std::string name);
  void check_child(const xml::Node& node, const xml::Node& child, const grammar::ElementRule& rule);
  void report_text(const xml::Node& node, const xml::Node& text);

  bool from_xacro_;
  const Suggested& suggested_;
  Tags& tags_;
  Diagnostics& diagnostics_;
  std::set<std::string> names_;                                ///< there, or offered
  std::map<const xml::Node*, std::set<std::string>> indices_;  ///< of the channels of an expander, likewise
  const xml::Node* around_ = nullptr;                          ///< of the tag that is checked
};

}  // namespace finemote::gen
