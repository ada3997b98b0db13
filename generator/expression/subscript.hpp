// value[key] and value[a:b:c].
#pragma once

#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

class Parameters;
class Runtime;

Value subscript(Runtime& runtime, const Value& container, const Value& key);

/// A key, or a list index counted from the end when negative, inside `size`; fails with `message` outside.
std::size_t checked_index(const Integer& index, std::size_t size, const char* message);

/// A slice fitted to a sequence: its first place, the place it ends before, and the way between them.
struct SliceWalk {
  std::int64_t start;
  std::int64_t stop;
  std::int64_t step;  ///< not 0; beyond 2^60 it counts as 2^60
};

/// Fails with Python's words on bounds that are no integers and on a step of 0.
SliceWalk walk_of(const Slice& slice, std::size_t size);

/// `slice.indices(n)`: start, stop and step for a sequence of n items, as a tuple.
Value slice_indices(Runtime& runtime, const Value& self, const Parameters& p);

/// The places a slice takes from a sequence of `size`, in its order.
std::vector<std::size_t> slice_places(const Slice& slice, std::size_t size);

}  // namespace finemote::gen::expression
