// value[key] and value[a:b:c].
#pragma once

#include "generator/xacro/value.hpp"

namespace finemote::gen::xacro {

class Runtime;

Value subscript(Runtime& runtime, const Value& container, const Value& key);

/// A key, or a list index counted from the end when negative, inside `size`; fails with `message` outside.
std::size_t checked_index(const Integer& index, std::size_t size, const char* message);

/// The places a slice takes from a sequence of `size`, in its order.
std::vector<std::size_t> slice_places(const Slice& slice, std::size_t size);

}  // namespace finemote::gen::xacro
