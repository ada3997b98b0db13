#include "generator/xml/prefixes.hpp"

namespace finemote::gen::xml {
namespace {

constexpr std::string_view kXmlUri = "http://www.w3.org/XML/1998/namespace";
constexpr std::string_view kXmlnsUri = "http://www.w3.org/2000/xmlns/";

/// What is wrong with `xmlns:prefix="uri"`, or nothing.
std::string_view check_declaration(std::string_view prefix, std::string_view uri) {
  if (prefix == "xmlns") return "reserved prefix (xmlns) must not be declared or undeclared";
  if (prefix == "xml" && uri != kXmlUri) {
    return "reserved prefix (xml) must not be undeclared or bound to another namespace name";
  }
  if (prefix != "xml" && (uri == kXmlUri || uri == kXmlnsUri)) {
    return "prefix must not be bound to one of the reserved namespace names";
  }
  return uri.empty() ? "must not undeclare prefix" : "";
}

}  // namespace

bool Prefixes::is_declared(std::string_view prefix) const {
  return prefix == "xml" || in_force_.contains(std::string(prefix));
}

std::string_view Prefixes::check_name(std::string_view name) const {
  const auto colon = name.find(':');
  if (colon == std::string_view::npos) return {};
  const bool malformed = colon == 0 || colon + 1 == name.size() || name.find(':', colon + 1) != std::string_view::npos;
  if (malformed) return "not well-formed (invalid token)";
  return is_declared(name.substr(0, colon)) ? "" : "unbound prefix";
}

std::string_view Prefixes::enter(const Node& element) {
  constexpr std::string_view kDeclaration = "xmlns:";
  open_sizes_.push_back(declared_.size());
  for (const Attribute& a : element.attributes) {
    if (!a.name.starts_with(kDeclaration)) continue;
    const std::string_view prefix = std::string_view(a.name).substr(kDeclaration.size());
    if (const auto wrong = check_declaration(prefix, a.value); !wrong.empty()) return wrong;
    declared_.emplace_back(prefix);
    in_force_.emplace(prefix);
  }
  if (const auto wrong = check_name(element.name); !wrong.empty()) return wrong;
  for (const Attribute& a : element.attributes) {
    if (a.name.starts_with(kDeclaration)) continue;
    if (const auto wrong = check_name(a.name); !wrong.empty()) return wrong;
  }
  return {};
}

void Prefixes::leave() {
  for (; declared_.size() > open_sizes_.back(); declared_.pop_back()) in_force_.erase(in_force_.find(declared_.back()));
  open_sizes_.pop_back();
}

}  // namespace finemote::gen::xml
