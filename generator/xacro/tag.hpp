// The attributes of a xacro tag.
#pragma once

#include <initializer_list>
#include <string_view>

#include "generator/xacro/context.hpp"
#include "generator/xacro/warnings.hpp"
#include "generator/xml/node.hpp"

namespace finemote::gen::xacro {

/// Fails with FM1020 when the attribute is missing.
const xml::Attribute& required(const xml::Node& tag, std::string_view name, const Context& context);

/// Warns of attributes that the tag does not know.
void check_attributes(const xml::Node& tag, std::initializer_list<std::string_view> known, const Context& context,
                      Warnings& warnings);

}  // namespace finemote::gen::xacro
