// The methods of str, in two tables: those that go by kinds of characters, and all others.
#pragma once

#include <string>
#include <string_view>

#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

/// The text a method was called on.
inline const std::string& text_of(const Value& self) { return *self.text(); }

/// The method of that name, or null.
const Method* find_str_method(std::string_view name);
/// Only among those of case_methods.cpp.
const Method* find_case_method(std::string_view name);

}  // namespace finemote::gen::expression
