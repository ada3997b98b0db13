// value.name: methods of texts, lists, dicts and sets, keys of dotted dicts, names of namespaces.
#pragma once

#include <string>

#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

class Runtime;

/// Fails with "'str' object has no attribute 'x'".
Value attribute_of(Runtime& runtime, const Value& value, const std::string& name);

struct Method;

/// The method of that name, or null.
const Method* find_list_method(std::string_view name);
const Method* find_tuple_method(std::string_view name);
const Method* find_dict_method(std::string_view name);
const Method* find_set_method(std::string_view name, bool is_frozen);
const Method* find_number_method(std::string_view name, bool is_real);

/// Fails when `container` is inside `item`: no value may contain itself.
void check_no_cycle(Runtime& runtime, const Value& container, const Value& item);

}  // namespace finemote::gen::expression
