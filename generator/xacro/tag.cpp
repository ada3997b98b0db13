#include "generator/xacro/tag.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace finemote::gen::xacro {

const xml::Attribute& required(const xml::Node& tag, std::string_view name, const Context& context) {
  const xml::Attribute* attribute = tag.attribute(name);
  if (attribute != nullptr) return *attribute;
  throw Failure{code::xacro_attribute,
                fmt::format("{}: missing attribute '{}'", tag.name, name),
                context.place(tag.at),
                {},
                {fmt::format("write <{} {}=\"...\" ...>", tag.name, name)}};
}

void check_attributes(const xml::Node& tag, std::initializer_list<std::string_view> known, const Context& context,
                      Warnings& warnings) {
  for (const xml::Attribute& a : tag.attributes) {
    const bool is_known = a.name.starts_with("xmlns:") || std::find(known.begin(), known.end(), a.name) != known.end();
    if (is_known) continue;
    warnings.add(code::xacro_unknown_attribute, context.place(a.at),
                 fmt::format("{}: unknown attribute(s): {}", tag.name, a.name));
  }
}

}  // namespace finemote::gen::xacro
