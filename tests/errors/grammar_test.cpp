// One grammar, written twice: the reader's table and the XSD for editors say the same.
#include "generator/model/grammar.hpp"

#include <algorithm>
#include <set>

#include "catch.hpp"
#include "generator/xml/parse.hpp"
#include "generator/xml/read_source.hpp"
#include "source_dir.hpp"

using namespace finemote::gen;

namespace {

/// All elements below a node that have this tag.
std::vector<const xml::Node*> find_all(const xml::Node& node, std::string_view tag) {
  std::vector<const xml::Node*> found;
  for (const xml::Node& child : node.children) {
    if (child.is_element(tag)) found.push_back(&child);
    for (const xml::Node* inner : find_all(child, tag)) found.push_back(inner);
  }
  return found;
}

std::string name_of(const xml::Node& node) {
  const xml::Attribute* name = node.attribute("name");
  return name == nullptr ? std::string() : name->value;
}

}  // namespace

TEST_CASE("the XSD knows the elements and attributes the reader knows") {
  Sources sources;
  Diagnostics diagnostics;
  const SourceFile* file =
      xml::read_source(finemote::test::source_dir() + "/schemas/finemote.xsd", sources, diagnostics);
  REQUIRE(file);
  const auto xsd = xml::parse(*file, diagnostics);
  REQUIRE(xsd);
  const auto types = find_all(xsd->root, "xs:complexType");
  for (const grammar::ElementRule& rule : grammar::rules()) {
    INFO(rule.name);
    const auto type =
        std::find_if(types.begin(), types.end(), [&](const xml::Node* node) { return name_of(*node) == rule.name; });
    REQUIRE(type != types.end());
    std::set<std::string> attributes, required, children;
    for (const xml::Node* attribute : find_all(**type, "xs:attribute")) {
      attributes.insert(name_of(*attribute));
      if (attribute->attribute("use") != nullptr) required.insert(name_of(*attribute));
    }
    for (const xml::Node* child : find_all(**type, "xs:element")) children.insert(name_of(*child));

    std::set<std::string> known, needed;
    for (const grammar::AttributeRule& attribute : rule.attributes) {
      known.emplace(attribute.name);
      if (attribute.required) needed.emplace(attribute.name);
    }
    CHECK(attributes == known);
    CHECK(required == needed);
    CHECK(children == std::set<std::string>(rule.children.begin(), rule.children.end()));
  }
}
