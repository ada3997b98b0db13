#include "tests/conformance/tree.hpp"

#include <map>
#include <vector>

namespace finemote::gen::conformance {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

/// A child as it counts: an element, or a text or comment with its squeezed content.
struct Part {
  const xml::Node* element = nullptr;
  std::string text;
  bool is_comment = false;
};

std::vector<Part> parts_of(const xml::Node& node, bool with_comments) {
  std::vector<Part> parts;
  std::string text;
  const auto flush = [&] {
    text = squeezed(text);
    if (!text.empty()) parts.push_back({nullptr, text, false});
    text.clear();
  };
  for (const xml::Node& child : node.children) {
    if (child.is_element()) {
      flush();
      parts.push_back({&child, {}, false});
    } else if (child.kind == xml::Node::Kind::text || child.kind == xml::Node::Kind::cdata) {
      text += child.text;
    } else if (child.kind == xml::Node::Kind::comment && with_comments) {
      flush();
      parts.push_back({nullptr, squeezed(child.text), true});
    }
  }
  flush();
  return parts;
}

std::map<std::string, std::string> attributes_of(const xml::Node& node) {
  std::map<std::string, std::string> attributes;
  for (const xml::Attribute& a : node.attributes) attributes[a.name] = squeezed(a.value);
  return attributes;
}

std::string describe(const Part& part) {
  if (part.element != nullptr) return "<" + part.element->name + ">";
  return (part.is_comment ? "comment '" : "text '") + part.text + "'";
}

}  // namespace

std::string squeezed(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (!is_blank(c)) {
      out += c;
    } else if (!out.empty() && out.back() != ' ') {
      out += ' ';
    }
  }
  if (!out.empty() && out.back() == ' ') out.pop_back();
  return out;
}

std::string difference(const xml::Node& expected, const xml::Node& given, bool with_comments) {
  if (expected.name != given.name) return "expected <" + expected.name + ">, got <" + given.name + ">";
  const std::string here = "<" + expected.name + ">: ";
  const auto wanted = attributes_of(expected);
  const auto found = attributes_of(given);
  for (const auto& [name, value] : wanted) {
    const auto other = found.find(name);
    if (other == found.end()) return here + "no attribute " + name;
    if (other->second != value) return here + name + ": expected '" + value + "', got '" + other->second + "'";
  }
  if (wanted.size() != found.size()) return here + "surplus attributes";

  const auto parts = parts_of(expected, with_comments);
  const auto others = parts_of(given, with_comments);
  for (std::size_t i = 0; i < parts.size() && i < others.size(); ++i) {
    const bool both_elements = parts[i].element != nullptr && others[i].element != nullptr;
    if (both_elements) {
      const std::string inner = difference(*parts[i].element, *others[i].element, with_comments);
      if (!inner.empty()) return here + inner;
    } else if (describe(parts[i]) != describe(others[i])) {
      return here + "expected " + describe(parts[i]) + ", got " + describe(others[i]);
    }
  }
  if (parts.size() > others.size()) return here + "missing " + describe(parts[others.size()]);
  if (others.size() > parts.size()) return here + "surplus " + describe(others[parts.size()]);
  return {};
}

}  // namespace finemote::gen::conformance
